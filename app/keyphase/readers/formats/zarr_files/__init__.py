"""The files of a Zarr store, checked before a codec unpacks them."""

from keyphase.readers.formats.zarr_files.stores import folder_store, zip_store

__all__ = ["folder_store", "zip_store"]
