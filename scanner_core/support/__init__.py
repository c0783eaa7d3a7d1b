"""What a technician sends when something does not work: one archive, shown before it is saved, without whose object it was.

The files in the order in which they are used::

    private_names    whose names must not be in it, and where they are known from
    redaction        takes them, and every path of the user's own, out of a text
    machine          versions, processors, memory, graphics
    case_sizes       the cases, by their size only
    bundle           collects the entries and writes the archive
"""
