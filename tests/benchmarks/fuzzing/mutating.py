"""Files changed as damage, haste and malice change them; the same seed gives the same change."""

import io
import random
import re
import zipfile
import zlib

_NUMBER = re.compile(rb"-?\d+\.?\d*(?:e-?\d+)?")
_WORDS = (
    b"nan", b"-inf", b"1e999", b"1e308", b"5e-324", b"-1", b"0", b"", b"null", b"true", b'"', b"[",
    b"{", b"9" * 400, b"99999999999999999999", b"1e-300", b"0x10", b"1_0", b"\xff", b"\x00",
    b"\xed\xa0\x80", b"\\ud800", b"\n", b",", b";", b"#", b"..", b"/dev/zero", b"[" * 2000,
    "٣".encode(), b"1" * 5000,
)  # fmt: skip


def mutated(data: bytes, chance: random.Random) -> bytes:
    """The bytes with one to four changes."""
    for _ in range(chance.choice((1, 1, 1, 2, 4))):
        data = chance.choice(_CHANGES)(data, chance)
    return data


def reseal(name: str, data: bytes, chance: random.Random) -> bytes:
    """Changed inside, with the sums around it right again, so that the change is reached."""
    if name.endswith(".npz"):
        return _inside_archive(data, chance)
    if name.endswith(".journal"):
        return _inside_lines(data, chance)
    return mutated(data, chance)


def _inside_archive(data: bytes, chance: random.Random) -> bytes:
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        members = {info.filename: archive.read(info) for info in archive.infolist()}
        packing = archive.infolist()[0].compress_type
    chosen = chance.choice(list(members))
    content = members[chosen]
    if chance.random() < 0.3:
        members[chosen] = mutated(content[:128], chance) + content[128:]
    elif chance.random() < 0.2:
        name = mutated(chosen.encode(), chance).decode("latin-1")[:200]
        # What comes after a NUL is no part of a name.
        members[name.partition("\0")[0] or "x"] = members.pop(chosen)
    else:
        members[chosen] = content[:128] + mutated(content[128:], chance)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", packing) as archive:
        for member, content in members.items():
            archive.writestr(member, content)
    return out.getvalue()


def _inside_lines(data: bytes, chance: random.Random) -> bytes:
    lines = data.split(b"\n")
    at = chance.randrange(len(lines))
    content = mutated(lines[at][9:], chance).replace(b"\n", b" ")
    lines[at] = b"%08x %s" % (zlib.crc32(content), content)
    return b"\n".join(lines)


def _bit(data: bytes, chance: random.Random) -> bytes:
    changed = bytearray(data)
    if changed:
        changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def _byte(data: bytes, chance: random.Random) -> bytes:
    changed = bytearray(data)
    if changed:
        changed[chance.randrange(len(changed))] = chance.choice((0, 255, 127, 128, 1, 32, 44, 10))
    return bytes(changed)


def _cut(data: bytes, chance: random.Random) -> bytes:
    return data[: chance.randrange(len(data) + 1)]


def _hole(data: bytes, chance: random.Random) -> bytes:
    begin = chance.randrange(len(data) + 1)
    return data[:begin] + data[begin + chance.choice((1, 2, 4, 8, 50, 500)) :]


def _twice(data: bytes, chance: random.Random) -> bytes:
    begin, length, to = (chance.randrange(len(data) + 1) for _ in range(3))
    return data[:to] + data[begin : begin + min(length, 2000)] + data[to:]


def _filled(data: bytes, chance: random.Random) -> bytes:
    begin, length = chance.randrange(len(data) + 1), chance.choice((1, 2, 4, 8, 64))
    filling = chance.choice((b"\0", b"\xff", b"\x7f"))
    return data[:begin] + filling * min(length, len(data) - begin) + data[begin + length :]


def _number(data: bytes, chance: random.Random) -> bytes:
    found = list(_NUMBER.finditer(data[:20_000]))
    if not found:
        return _byte(data, chance)
    one = chance.choice(found)
    return data[: one.start()] + chance.choice(_WORDS) + data[one.end() :]


def _word(data: bytes, chance: random.Random) -> bytes:
    at = chance.randrange(len(data) + 1)
    return data[:at] + chance.choice(_WORDS) + data[at:]


_CHANGES = (_bit, _byte, _cut, _hole, _twice, _filled, _number, _number, _word)
