package lightning.bench.report;

/** Writes a table: a title for each column, the first column names, all others numbers. */
final class HtmlTable implements AutoCloseable {
    private final HtmlWriter page;

    /** @param style a class of the style sheet, or null */
    HtmlTable(HtmlWriter page, String style, String caption, String... columns) {
        this.page = page;
        page.open("div", "class", "wide").open("table", "class", style);
        page.element("caption", caption);
        page.open("thead").open("tr");
        for (String column : columns) {
            page.element("th", column, "scope", "col");
        }
        page.close().close().open("tbody");
    }

    /** A row; a cell that starts with {@code −} is a loss, and so is marked. */
    void row(String name, String... cells) {
        page.open("tr").element("th", name, "scope", "row");
        for (String cell : cells) {
            page.element("td", cell, "class", cell.startsWith("−") ? "loss" : null);
        }
        page.close();
    }

    @Override
    public void close() {
        page.close().close().close();
    }
}
