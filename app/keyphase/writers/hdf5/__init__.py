"""HDF5 files of robomimic, MimicGen and REASSEMBLE, into a copy."""
