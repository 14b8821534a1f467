package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/** Writer for new scene texts: omits defaults and writes one block per line if it fits. */
public final class JenWriter {
    static final int MAX_LINE_LENGTH = 110;

    private JenWriter() {}

    /**
     * Returns the text of a scene file that reads back as {@code scene}, bit-identical.
     *
     * @throws IllegalArgumentException if a texture's file name is not valid in a scene file
     */
    public static String write(Scene scene) {
        List<BlockContent> header = new ArrayList<>(List.of(BlockContent.of(BlockTypes.PICTURE, scene.picture()),
                BlockContent.of(BlockTypes.CAMERA, scene.camera()), BlockContent.of(BlockTypes.WORLD, scene.world())));
        header.removeIf(BlockContent::isInitial);
        var out = new StringBuilder("jen 1\n");
        section(out, header);
        section(out, scene.cameras().stream().map(BlockContent::of).toList());
        section(out, scene.world().named().stream().map(BlockContent::of).toList());
        section(out, scene.materials().stream().map(BlockContent::of).toList());
        section(out, scene.nodes().stream().map(BlockContent::of).toList());
        section(out, scene.rig().lightGroups().stream().map(BlockContent::of).toList());
        section(out, scene.lights().stream().map(BlockContent::of).toList());
        return out.toString();
    }

    /**
     * Returns the text of a scene file that reads back as {@code scene} and {@code shot}, bit-identical.
     *
     * @param shot shot of that scene
     * @throws IllegalArgumentException as {@link #write(Scene)}, and if an animated object is not in the scene
     */
    public static String write(Scene scene, Shot shot) {
        shot.check(scene);
        return write(scene) + '\n' + new ShotWriter(scene, "\n").block(shot) + '\n';
    }

    private static void section(StringBuilder out, List<BlockContent> elements) {
        if (!elements.isEmpty()) {
            out.append('\n');
            elements.forEach(e -> out.append(block(e, "", "\n")).append('\n'));
        }
    }

    /**
     * Returns the text of one block, without a final line end.
     *
     * @param indent prefix of each line, including the first
     */
    static String block(BlockContent element, String indent, String newline) {
        var header = new StringBuilder(indent).append(element.type().keyword());
        if (element.type().isNamed()) {
            header.append(' ').append(NameSyntax.format(element.name()));
        }
        element.type().header().ifPresent(p -> header.append(' ').append(element.value(p).text()));
        List<String> properties = properties(element);
        String line = header + " " + braces(properties);
        if (element.children().isEmpty() && line.length() <= MAX_LINE_LENGTH) {
            return line;
        }
        header.append(" {").append(newline);
        properties.forEach(p -> header.append(indent).append("  ").append(p).append(newline));
        element.children().forEach(c -> header.append(block(c, indent + "  ", newline)).append(newline));
        return header.append(indent).append('}').toString();
    }

    /** Returns the texts of the properties that must be written. */
    static List<String> properties(BlockContent element) {
        return element.type().properties().stream().filter(element::mustWrite).map(p -> property(p, element.value(p)))
                .toList();
    }

    /** Returns properties in braces, on one line. */
    static String braces(List<String> properties) {
        return properties.isEmpty() ? "{}" : "{ " + String.join("  ", properties) + " }";
    }

    /** Returns the text of a property, name and value. */
    static String property(Property<?> property, Value value) {
        property.checkValue(value);
        return property.name() + " " + value.text();
    }
}
