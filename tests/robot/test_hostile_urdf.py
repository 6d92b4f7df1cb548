"""URDFs made to take minutes or gigabytes, or to end the program that reads them."""

import os

import pytest

from keyphase.errors import RobotError
from keyphase.robot.mesh_files import MeshFiles
from keyphase.urdf.checking import refuse_bad_urdf

ROBOT = '<robot name="r"><link name="a"/></robot>'


def robot(parts):
    """A robot of one link and further parts."""
    return ROBOT.replace("</robot>", f"{parts}</robot>")


def joint(name, parent, child):
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="fixed">{ends}</joint>'


def looks(shape):
    """A robot whose only link looks like this."""
    return ROBOT.replace(
        '<link name="a"/>',
        f'<link name="a"><visual><geometry>{shape}</geometry></visual></link>',
    )


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (f'<!DOCTYPE r [<!ENTITY a "lol">]>{ROBOT}', "entities of its own"),
        (f'<?xml version="1.0" encoding="rot13"?>{ROBOT}', "says it is 'rot13'"),
        (f'<?xml version="1.0" encoding="zlib"?>{ROBOT}', "says it is 'zlib'"),
        (f'<?xml version="1.0" encoding="{"x" * 1000}"?>{ROBOT}', "says it is 'xxx"),
        ("<a>" * 100_000, "no XML"),
        ("", "no XML"),
        (robot('<link name="b"/>' + joint("j", "b", "b")), "some of them form loops"),
        (robot('<link name="b"/>' + joint("j", "a", "b") + joint("k", "a", "b")), "hangs on 2"),
        (robot("".join(f'<link name="l{i}"/>' for i in range(600))), "may have 500 links"),
        (ROBOT.replace("<link", "<link " + " ".join(f'x{i}="1"' for i in range(99))), "attributes"),
        (looks("").replace("<visual>", "<visual/>" * 2000 + "<visual>"), "may have 2000 shapes"),
        (looks('<cylinder radius="inf" length="0.2"/>'), "must have a number for radius"),
        (looks('<box size="-1"/>'), "must have 3 numbers for size"),
        (looks('<sphere radius="1e300"/>'), "must have a number for radius"),
    ],
    ids=range(14),
)
def test_it_is_refused_in_a_sentence(tmp_path, text, reason):
    path = tmp_path / "r.urdf"
    path.write_text(text)
    with pytest.raises(RobotError, match=reason):
        refuse_bad_urdf(path)


def test_a_sound_one_in_any_common_encoding_passes(tmp_path):
    path = tmp_path / "r.urdf"
    for name in ("utf-8", "utf-16", "iso-8859-1"):
        path.write_bytes(f'<?xml version="1.0" encoding="{name}"?>{ROBOT}'.encode(name))
        refuse_bad_urdf(path)


def test_a_pipe_is_refused_at_once(tmp_path):
    os.mkfifo(tmp_path / "r.urdf")
    with pytest.raises(RobotError, match="no regular file"):
        refuse_bad_urdf(tmp_path / "r.urdf")


def test_meshes_that_are_no_files_or_no_meshes_are_not_opened(tmp_path):
    files = MeshFiles(tmp_path / "r.urdf")
    os.mkfifo(tmp_path / "pipe.stl")
    (tmp_path / "mesh.svg").write_text("<svg/>")
    (tmp_path / "mesh.dae").write_text('<!DOCTYPE c [<!ENTITY a "lol">]><COLLADA>&a;</COLLADA>')
    for name, reason in (
        ("pipe.stl", "no regular file"),
        ("mesh.svg", "must be one of .stl"),
        ("mesh.dae", "declares a document type"),
    ):
        with pytest.raises(RobotError, match=reason):
            files.let_in(name, tmp_path / name)


def test_meshes_that_would_take_minutes_are_refused_by_their_size_together(tmp_path):
    files = MeshFiles(tmp_path / "r.urdf")
    for number in range(3):
        with (tmp_path / f"{number}.obj").open("wb") as file:
            file.truncate(3 << 20)
    files.let_in("0.obj", tmp_path / "0.obj")
    files.let_in("0.obj", tmp_path / "0.obj")
    files.let_in("1.obj", tmp_path / "1.obj")
    with pytest.raises(RobotError, match=r"the mesh '2.obj' brings the meshes of its kind to"):
        files.let_in("2.obj", tmp_path / "2.obj")
