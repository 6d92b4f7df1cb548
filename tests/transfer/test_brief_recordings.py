"""Recordings of a few samples teach and are proposed to like any other: nothing ends over them."""

from dataclasses import replace

import pytest

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.labeling.label import label
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.transfer.proposing import propose
from keyphase.transfer.taught import taught_by


def shortened(rows: int, stride: int) -> Demonstration:
    whole = read(shipped("data") / "setup1.npz")
    taken = slice(0, rows * stride, stride)
    force = whole.force_N
    assert force is not None
    brief = Demonstration("brief", whole.time_s[taken], whole.position_m[taken])
    return replace(brief, force_N=force[taken])


@pytest.mark.parametrize(("rows", "stride"), [(2, 1), (3, 1), (3, 500), (10, 1)])
def test_what_hardly_lasts_fits_itself_and_ends_no_proposal(rows: int, stride: int) -> None:
    brief, whole = shortened(rows, stride), read(shipped("data") / "setup1.npz")
    ours, theirs = segment(brief), segment(whole)
    taught = [taught_by(label(each)) for each in (ours, theirs)]

    assert len(propose(taught[0], brief, ours).phases) == 1
    propose(taught[0], whole, theirs)
    propose(taught[1], brief, ours)
