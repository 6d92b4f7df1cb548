"""A Parquet file by itself, as pandas and others write it: its columns by their names."""

from pathlib import Path

import numpy as np

from keyphase.errors import DemonstrationError
from keyphase.files.bounded_memory import memory_bounded
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import damage_told
from keyphase.readers.formats.lerobot import (
    EXTRA,
    columns_of_parquet,
    texts_of_parquet,
)
from keyphase.readers.formats.numeric import refuse_too_large
from keyphase.readers.formats.packages import package

MAGIC = b"PAR1"
_MAX_DEPTH = 4
"""So deep are records within records looked into."""


class _Declared:
    """A column as large as the file says it will be."""

    def __init__(self, rows: int) -> None:
        self.shape, self.dtype = (rows,), np.dtype(np.float64)


def table_of_parquet(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """Columns of numbers, of equally long lists of numbers, of dates as seconds since 1970, and of
    records, whose fields are columns.

    Raises DemonstrationError for what cannot be read, MissingPackageError where pyarrow is not
    installed.
    """
    if part is not None:
        raise DemonstrationError(f"{path}: it is one recording; name it without #{part[:80]}.")
    parquet = package("pyarrow.parquet", EXTRA, path)
    arrow = package("pyarrow", EXTRA, path)
    compute = package("pyarrow.compute", EXTRA, path)
    told, bounded = damage_told(path, "Parquet file"), memory_bounded(path)
    with told, bounded, parquet.ParquetFile(path) as file:
        rows, width = file.metadata.num_rows, file.metadata.num_columns
        refuse_too_large([_Declared(rows)] * width, str(path), limit_bytes)
        table = file.read(use_threads=False)
        for _ in range(_MAX_DEPTH):
            table = table.flatten()
        for at, one in enumerate(table.schema):
            if arrow.types.is_timestamp(one.type):
                whole = table[one.name].cast(arrow.timestamp("ns")).cast(arrow.int64())
                seconds = compute.divide(whole.cast(arrow.float64(), safe=False), 1e9)
                table = table.set_column(at, one.name, seconds)
        columns = dict(columns_of_parquet(table))
        refuse_too_large(columns.values(), str(path), limit_bytes)
        texts = dict(texts_of_parquet(table))
    return ArrayTable(str(path), columns, texts, (), {})
