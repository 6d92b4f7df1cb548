"""The table of formats that the documents show, made from the code."""

from keyphase.readers.formats.known import FORMATS
from keyphase.readers.recipes.presets import example_of, left_open, preset_names, preset_values

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
    rows = ["| preset | channels | left open | example |", "|---|---|---|---|"]
    for name in preset_names():
        values = preset_values(name, name)
        tools = [one["name"] for one in values.get("demonstration", ())]
        every = {**values, **(values["demonstration"][0] if tools else {})}
        channels = [section for section in _SHOWN if section in every]
        if tools:
            channels.append(f"each of {' and '.join(tools)}")
        missing = [
            f"`[{section}]{'' if section == 'robot' else _key(line)}`"
            for section, lines in left_open(name).items()
            for line in (lines[:1] if section == "robot" else lines)
        ]
        left = ", ".join(missing) or "nothing"
        rows.append(f"| `{name}` | {', '.join(channels)} | {left} | `{example_of(name)}` |")
    return "\n".join(rows)


def _key(line: str) -> str:
    """The key a commented line of a recipe is about."""
    return " " + line.removeprefix("#").partition("=")[0].strip()
