"""The one kind of array that keyphase computes with."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
