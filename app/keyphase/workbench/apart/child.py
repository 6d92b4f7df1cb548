"""The process that reads: asked on its standard input, answering on its standard output.

Both ends are keyphase's own, of one version and one person; no file is ever unpickled.
"""

import os
import pickle
import signal
import sys

import keyphase.readers  # noqa: F401  what every file needs, before the first is asked for


def main() -> None:
    """Answer until nobody asks any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # What a library prints goes where errors go, not among the answers.
    with os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)
        while True:
            try:
                function, given = pickle.load(sys.stdin.buffer)
            except EOFError:
                return
            pickle.dump(_answer(function, given), answers, protocol=pickle.HIGHEST_PROTOCOL)
            answers.flush()


def _answer(function, given) -> tuple[bool, object]:
    try:
        return True, function(*given)
    except Exception as error:
        return False, _sendable(error)


def _sendable(error: Exception) -> Exception:
    try:
        pickle.loads(pickle.dumps(error))
    except Exception:
        return RuntimeError(f"{type(error).__name__}: {error}")
    return error


if __name__ == "__main__":
    main()
