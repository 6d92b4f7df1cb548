"""The table of formats that the documents show, made from the code."""

from keyphase.readers.formats.known import FORMATS
from keyphase.readers.recipes.presets import preset_names, preset_values

_SHOWN = (
    *("pose", "position", "orientation", "force", "torque", "joints", "joint_torques", "gripper"),
)


def formats_table() -> str:
    """Formats read as columns, as Markdown: endings, what to install, an example of a path."""
    rows = ["| format | ends in | install | example |", "|---|---|---|---|"]
    for form in FORMATS:
        install = f'`pip install "keyphase[{form.extra}]"`' if form.extra else "nothing more"
        rows.append(f"| {form.name} | {form.endings} | {install} | `{form.example}` |")
    return "\n".join(rows)


def presets_table() -> str:
    """Presets as Markdown, with what each leaves open."""
    rows = ["| preset | channels | left open |", "|---|---|---|"]
    for name in preset_names():
        values = preset_values(name, name)
        tools = [one["name"] for one in values.get("demonstration", ())]
        every = {**values, **(values["demonstration"][0] if tools else {})}
        channels = [section for section in _SHOWN if section in every]
        if tools:
            channels.append(f"each of {' and '.join(tools)}")
        wrench = values.get("wrench", {})
        has_load = "force" in values or "torque" in values
        missing = [] if "time" in values else ["`[time] rate_hz`"]
        missing += [f"`[wrench] {k}`" for k in ("frame", "sign") if has_load and k not in wrench]
        missing += ["`[robot]`"] if not {"pose", "position"} & every.keys() else []
        missing += ["`[joint_torques] sign`"] if "joint_torques" in values else []
        rows.append(f"| `{name}` | {', '.join(channels)} | {', '.join(missing) or 'nothing'} |")
    return "\n".join(rows)
