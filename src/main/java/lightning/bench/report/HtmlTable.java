package lightning.bench.report;

import org.jspecify.annotations.Nullable;

/** Writer of a table: a title per column, names in the first, numbers in all others. */
final class HtmlTable implements AutoCloseable {
    private final HtmlWriter page;

    /** @param style style sheet class */
    HtmlTable(HtmlWriter page, @Nullable String style, String caption, String... columns) {
        this.page = page;
        page.open("div", "class", "wide").open("table", "class", style);
        page.element("caption", caption);
        page.open("thead").open("tr");
        for (String column : columns) {
            page.element("th", column, "scope", "col");
        }
        page.close().close().open("tbody");
    }

    /** Writes a row; cells that start with {@code −} are marked as losses. */
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
