"""What new parameters of a folder would do, before they do it."""

from handmade import Person, described, segmentation

from keyphase.labeling.edits import Add, Done, Label
from keyphase.labeling.spreading import preview
from keyphase.segmentation.parameters import Parameters

MORE = Parameters(force_ratio=1.0)


def segment(parameters):
    if parameters.force_ratio < 10:
        return segmentation((2.05, 6.0, 7.0, 8.0))
    return segmentation((2.0, 4.0, 6.0, 8.0))


def test_it_says_which_boundaries_come_go_and_move():
    change = preview(Person(segmentation()).document, MORE, segment, described)
    assert (change.comes_s, change.goes_s, change.moves_s) == ((7.0,), (4.0,), ((2.0, 2.05),))
    assert not change.is_none


def test_edits_stay_and_those_that_lose_their_place_are_named():
    person = Person(segmentation((2.0, 4.0, 6.0, 8.0)))
    person.makes(Add(7.0), Label(3.0, "insert"), Label(5.0, "press"))
    change = preview(person.document, MORE, segment, described)
    assert change.comes_s == ()
    assert [("insert" in text) for text in change.newly_inapplicable] == [True]


def test_parameters_set_on_the_recording_alone_go_on_holding():
    document = Person(segmentation()).document.set_parameters(Parameters(force_ratio=30.0))
    change = preview(document, MORE, segment, described)
    assert change.is_none
    assert change.own == ("Ratio 30",)


def test_the_same_parameters_change_nothing():
    assert preview(Person(segmentation()).document, Parameters(), segment, described).is_none


def test_a_finished_recording_is_left_alone_and_says_so():
    person = Person(segmentation())
    person.makes(Done())
    change = preview(person.document, Parameters(force_ratio=3.0), _finds_more, described)
    assert change.is_none
    assert change.done


def test_a_finished_recording_is_opened_again_only_on_request():
    person = Person(segmentation())
    person.makes(Done())
    shared = Parameters(force_ratio=3.0)
    change = preview(person.document, shared, _finds_more, described, include_done=True)
    assert change.comes_s == (1.0,)
    assert person.document.done


def _finds_more(parameters):
    more = (1.0,) if parameters.force_ratio == 3.0 else ()
    return segmentation((*more, 2.0, 4.0, 6.0, 8.0), parameters=parameters)
