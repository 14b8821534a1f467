package lightning.base.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.List;

/**
 * HTML page in one file, which needs no server and no network. Its template has {@code {{style}}}, {@code {{script}}} and {@code {{data}}},
 * and a content security policy with {@code {{style-hash}}} and {@code {{script-hash}}}, which allows its own style and script only.
 */
public final class HtmlPage {
    private static final String SCRIPT_START = "\"use strict\";\n(async () => {\n";
    private static final String SCRIPT_END = "})();\n";

    private HtmlPage() {}

    /**
     * Returns a page without its data.
     *
     * @param owner   class next to whose file all resources are
     * @param scripts parts of the script by topic, joined in the order in which they use each other
     * @throws IOException if a resource cannot be read
     */
    public static String withoutData(Class<?> owner, String template, String style, List<String> scripts) throws IOException {
        String css = resource(owner, style);
        var script = new StringBuilder(SCRIPT_START);
        for (String part : scripts) {
            script.append(resource(owner, part));
        }
        String js = script.append(SCRIPT_END).toString();
        return resource(owner, template).replace("{{style-hash}}", hash(css)).replace("{{script-hash}}", hash(js)).replace("{{style}}", css)
                .replace("{{script}}", js);
    }

    /** Inserts data. A script of data ends at the next tag, so no character of it may begin one. */
    public static String withData(String page, String json) {
        return page.replace("{{data}}", json.replace("<", "\\u003c"));
    }

    private static String resource(Class<?> owner, String name) throws IOException {
        try (InputStream in = owner.getResourceAsStream(name)) {
            if (in == null) {
                throw new IllegalStateException("the resource " + name + " is missing");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static String hash(String text) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return "sha256-" + Base64.getEncoder().encodeToString(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
