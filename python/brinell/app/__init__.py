# SPDX-License-Identifier: BSD-3-Clause
"""The page to work on, ``brinell app``: forms, checks, runs and pictures in a browser, served on this machine only."""
