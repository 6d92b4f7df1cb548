"""Binary formats of other people's: which recordings a file holds, and one of them as columns.

Each format is an optional extra and imported only when such a file is met.
"""
