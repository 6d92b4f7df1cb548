"""How many processes work at once."""

from keyphase.errors import ParameterError


def require_jobs(jobs: int) -> None:
    """Raise ParameterError for a number of processes that means nothing; see joblib's n_jobs."""
    if jobs == 0:
        raise ParameterError("jobs must be a number of processes or -1 for all cores, but is 0.")
