package lightning.format.usd;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.stream.Collectors;

/** Layer of a USD stage as text: prims that it adds, or changes in layers below it. */
public final class UsdLayer {
    private static final String INDENT = "    ";

    /** Text of the largest number. */
    public static final String LARGEST = number(Float.MAX_VALUE);

    private final Map<String, String> metadata = new LinkedHashMap<>();
    private final Prim root = new Prim("");

    /** Prim with its attributes and children. */
    public static final class Prim {
        private final String name;
        private final Map<String, Prim> children = new LinkedHashMap<>();
        private final Map<String, String> metadata = new LinkedHashMap<>();
        private final Map<String, String> attributes = new LinkedHashMap<>();
        private String specifier = "over";

        private Prim(String name) {
            this.name = name;
        }

        /** Makes it a new prim of a type, instead of one that a layer below has. */
        public Prim define(String type) {
            specifier = "def " + type;
            return this;
        }

        /** Sets metadata, such as {@code active}. */
        public void metadata(String key, String value) {
            metadata.put(key, value);
        }

        /** Sets the value of an attribute or a relationship, declared with its type. */
        public void set(String declaration, String value) {
            attributes.put(declaration, value);
        }

        /** Sets the values of an attribute at several times. */
        public void set(String declaration, SortedMap<Integer, String> samples) {
            attributes.put(declaration + ".timeSamples", samples.entrySet().stream().map(e -> e.getKey() + ": " + e.getValue())
                    .collect(Collectors.joining(", ", "{ ", " }")));
        }

        private void write(StringBuilder out, String indent) {
            out.append(indent).append(specifier).append(' ').append(quoted(name));
            if (!metadata.isEmpty()) {
                out.append(" (\n");
                metadata.forEach((key, value) -> out.append(indent).append(INDENT).append(key).append(" = ").append(value).append('\n'));
                out.append(indent).append(")");
            }
            out.append('\n').append(indent).append("{\n");
            attributes.forEach((key, value) -> out.append(indent).append(INDENT).append(key).append(" = ").append(value).append('\n'));
            children.values().forEach(child -> child.write(out, indent + INDENT));
            out.append(indent).append("}\n");
        }
    }

    /** Sets metadata of the layer, such as {@code upAxis}. */
    public void metadata(String key, String value) {
        metadata.put(key, value);
    }

    /** Returns the prim at a path such as {@code /World/key}; one that changes a layer below, until it is defined. */
    public Prim prim(String path) {
        Prim prim = root;
        for (String name : path.substring(1).split("/")) {
            prim = prim.children.computeIfAbsent(name, Prim::new);
        }
        return prim;
    }

    /** Returns whether the layer has a prim at a path. */
    public boolean contains(String path) {
        Optional<Prim> prim = Optional.of(root);
        for (String name : path.substring(1).split("/")) {
            prim = prim.map(p -> p.children.get(name));
        }
        return prim.isPresent();
    }

    /** Returns the text. */
    public String text() {
        var out = new StringBuilder("#usda 1.0\n(\n");
        metadata.forEach((key, value) -> out.append(INDENT).append(key).append(" = ").append(value).append('\n'));
        out.append(")\n");
        for (Prim prim : new ArrayList<>(root.children.values())) {
            out.append('\n');
            prim.write(out, "");
        }
        return out.toString();
    }

    /** Returns a number as a float, which all lights have; the largest one in place of a larger number. */
    public static String number(double v) {
        String text = Float.toString((float) Math.clamp(v, -Float.MAX_VALUE, Float.MAX_VALUE));
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }

    /** Returns text in quotes. */
    public static String quoted(String text) {
        return "\"" + text.replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
    }

    /** Returns the name of a file. */
    public static String asset(String path) {
        return "@" + path + "@";
    }

    /** Returns the value of a relationship to prims. */
    public static String targets(List<String> paths) {
        return paths.stream().map(path -> "<" + path + ">").collect(Collectors.joining(", ", "[", "]"));
    }
}
