package lightning.bench.report;

/** Writes a table: a title for each column, the first column names, all others numbers. */
final class Table implements AutoCloseable {
    private final Markup page;

    /** @param style a class of the style sheet, or null */
    Table(Markup page, String style, String caption, String... columns) {
        this.page = page;
        page.open("div", "class", "wide").open("table", "class", style);
        page.leaf("caption", caption);
        page.open("thead").open("tr");
        for (String column : columns) {
            page.leaf("th", column, "scope", "col");
        }
        page.close().close().open("tbody");
    }

    /** A row; a cell that starts with {@code −} is a loss, and so is marked. */
    void row(String name, String... cells) {
        page.open("tr").leaf("th", name, "scope", "row");
        for (String cell : cells) {
            page.leaf("td", cell, "class", cell.startsWith("−") ? "loss" : null);
        }
        page.close();
    }

    @Override
    public void close() {
        page.close().close().close();
    }
}
