package lightning.format.review;

import java.io.IOException;
import java.util.List;

/** Script of a page: parts by topic, joined in the order in which they use each other. */
final class PageScript {
    private static final List<String> PARTS =
            List.of("texts", "layers", "state", "picture", "faders", "notes", "compare", "film", "save", "file", "live", "start");

    private PageScript() {}

    /** Returns the whole script. */
    static String text() throws IOException {
        var script = new StringBuilder("\"use strict\";\n(async () => {\n");
        for (String part : PARTS) {
            script.append(PageResource.text("page/" + part + ".js"));
        }
        return script.append("})();\n").toString();
    }
}
