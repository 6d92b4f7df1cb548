"""The wheel works by itself: in an empty environment, outside the checkout."""

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from email import message_from_bytes
from pathlib import Path
from zipfile import ZipFile

import pytest
from filelock import FileLock

from linked_environment import environment_with

ROOT = Path(__file__).parents[1]

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of all processes of this run, with the wheel: what one made serves the others."""
    own = tmp_path_factory.getbasetemp()
    folder = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "installed"
    with FileLock(f"{folder}.lock"):
        folder.mkdir(exist_ok=True)
        if not list(folder.glob("*.whl")):
            command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir"]
            subprocess.run([*command, folder, ROOT], check=True, capture_output=True)
    return folder


@pytest.fixture(scope="module")
def installed(shared: Path) -> Path:
    """The bin folder of an environment that holds nothing but the wheel and what it needs."""
    (wheel,) = shared.glob("*.whl")
    with ZipFile(wheel) as archive:
        (name,) = [one for one in archive.namelist() if one.endswith(".dist-info/METADATA")]
        needed = message_from_bytes(archive.read(name)).get_all("Requires-Dist", [])
    return _with_the_wheel(wheel, shared / "environment", needed)


@pytest.fixture(scope="module")
def core(shared: Path) -> Path:
    """The bin folder of an environment with the inner ring only: no page, robot or simulation."""
    (wheel,) = shared.glob("*.whl")
    lines = (ROOT / "requirements-core.txt").read_text().splitlines()
    needed = [line for line in lines if not line.startswith("#")]
    return _with_the_wheel(wheel, shared / "core", needed)


def _with_the_wheel(wheel: Path, folder: Path, needed: list[str]) -> Path:
    with FileLock(f"{folder}.lock"):
        programs = folder / "bin"
        if not (programs / "keyphase").exists():
            environment_with(folder, (one for one in needed if "extra ==" not in one))
            pip = [sys.executable, "-m", "pip", "--python", programs / "python", "install"]
            subprocess.run([*pip, "--quiet", "--no-compile", "--no-deps", wheel], check=True)
    return programs


def run(installed: Path, *arguments: object, cwd: Path) -> str:
    """Run the installed command far from the checkout, seeing nothing of this environment."""
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "VIRTUAL_ENV"))}
    done = subprocess.run(
        [installed / "keyphase", *map(str, arguments)],
        cwd=cwd,
        env=clean,
        check=True,
        capture_output=True,
        text=True,
    )
    return done.stdout


def test_wheel_holds_the_shipped_recordings_and_robots(installed: Path, tmp_path: Path) -> None:
    code = (
        "from keyphase.files.shipped import shipped;"
        "print(*sorted(p.name for p in shipped('data').iterdir()));"
        "print(*sorted(p.name for p in shipped('static_robots').iterdir()))"
    )
    done = subprocess.run(
        [installed / "python", "-c", code], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    data, robots = done.stdout.splitlines()
    assert "setup1.npz" in data.split()
    assert "yumi" in robots.split()


def test_installed_keyphase_segments_a_shipped_recording(installed: Path, tmp_path: Path) -> None:
    (site,) = installed.parent.glob("lib/python*/site-packages/keyphase/_shipped/data")
    run(installed, "segment", site / "setup1.npz", "--output", tmp_path / "out", cwd=tmp_path)
    assert (tmp_path / "out" / "setup1.segments.json").is_file()


@pytest.fixture
def served(installed: Path, tmp_path: Path) -> Iterator[str]:
    process = subprocess.Popen(
        [installed / "keyphase", "--no-browser"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    )
    assert process.stdout is not None
    for line in process.stdout:
        if link := re.search(r"http://\S+token=\S+", line):
            yield link[0]
            break
    process.terminate()
    process.wait()


def test_installed_keyphase_serves_the_page(served: str) -> None:
    import httpx

    with httpx.Client(follow_redirects=True) as client:
        page = client.get(served)
        assert page.status_code == 200
        for script in re.findall(r'(?:src|href)="(/app/static/[^"]+)"', page.text):
            assert client.get(f"{served.split('/?')[0]}{script}").status_code == 200, script


def test_the_inner_ring_segments_and_scores_without_page_robot_or_simulation(
    core: Path, tmp_path: Path
) -> None:
    (data,) = core.parent.glob("lib/python*/site-packages/keyphase/_shipped/data")
    run(core, "segment", data / "setup1.npz", "--output", tmp_path / "out", cwd=tmp_path)
    (tmp_path / "truth.json").write_text('{"setup1": {"events": [[1, "any"]], "tolerance_s": 9}}')
    assert "setup1" in run(core, "score", "truth.json", "out", "--json", cwd=tmp_path)
    assert "segment" in run(core, "--help", cwd=tmp_path)


def test_the_inner_ring_reads_labels_and_makes_skills(core: Path, tmp_path: Path) -> None:
    code = """
import keyphase
from keyphase.files.shipped import shipped
demonstration = keyphase.read(shipped("data") / "setup1.npz")
labeling = keyphase.label(keyphase.segment(demonstration, keyphase.Parameters()))
keyphase.write_segment_file(labeling, __import__("pathlib").Path("one.segments.json"))
file = keyphase.read_segment_file(__import__("pathlib").Path("one.segments.json"))
print(len(keyphase.skills_of(demonstration, file.segments)))
"""
    done = subprocess.run(
        [core / "python", "-c", code], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    assert int(done.stdout) >= 3


def test_a_command_whose_package_is_missing_says_so_in_one_line(core: Path, tmp_path: Path) -> None:
    done = subprocess.run(
        [core / "keyphase", "open", "--no-browser"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 1
    assert done.stderr.startswith("keyphase: This needs the package '")
    assert done.stderr.count("\n") == 1
