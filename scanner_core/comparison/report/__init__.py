"""The report of a comparison: a page for the record, the same for a browser, a table for a spreadsheet, the surface with its deviations."""
