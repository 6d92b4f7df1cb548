"""URDFs made to take minutes or gigabytes, or to end the program that reads them."""

import os

import pytest

from keyphase.errors import RobotError
from keyphase.robot.urdf import refuse_bad_urdf

ROBOT = '<robot name="r"><link name="a"/></robot>'


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (f'<!DOCTYPE r [<!ENTITY a "lol">]>{ROBOT}', "entities of its own"),
        (f'<?xml version="1.0" encoding="rot13"?>{ROBOT}', "says it is 'rot13'"),
        (f'<?xml version="1.0" encoding="zlib"?>{ROBOT}', "says it is 'zlib'"),
        (f'<?xml version="1.0" encoding="{"x" * 1000}"?>{ROBOT}', "says it is 'xxx"),
        ("<a>" * 100_000, "no XML"),
        ("", "no XML"),
    ],
    ids=range(6),
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
