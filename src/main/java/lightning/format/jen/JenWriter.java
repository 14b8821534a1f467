package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/** Writes scenes from scratch: only what is not the default, one block per line where it fits. */
public final class JenWriter {
    static final int MAX_LINE_LENGTH = 110;

    private JenWriter() {}

    /**
     * The text of a scene file that reads back as {@code scene} in every bit.
     *
     * @throws IllegalArgumentException if a texture's file name is none that a scene file can say
     */
    public static String write(Scene scene) {
        List<BlockContent> header = new ArrayList<>(List.of(BlockContent.of(BlockTypes.PICTURE, scene.picture()),
                BlockContent.of(BlockTypes.CAMERA, scene.camera()), BlockContent.of(BlockTypes.WORLD, scene.world())));
        header.removeIf(BlockContent::isInitial);
        var out = new StringBuilder("jen 1\n");
        section(out, header);
        section(out, scene.materials().stream().map(BlockContent::of).toList());
        section(out, scene.nodes().stream().map(BlockContent::of).toList());
        section(out, scene.rig().lightGroups().stream().map(BlockContent::of).toList());
        section(out, scene.lights().stream().map(BlockContent::of).toList());
        return out.toString();
    }

    /**
     * The text of a scene file that reads back as {@code scene} and {@code shot} in every bit.
     *
     * @param shot one of that scene
     * @throws IllegalArgumentException as {@link #write(Scene)}, and if something with keys is not in the scene
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
     * One block without a line end behind it.
     *
     * @param indent what stands before each of its lines (the first included)
     */
    static String block(BlockContent element, String indent, String newline) {
        var header = new StringBuilder(indent).append(element.type().keyword());
        if (element.type().isNamed()) {
            header.append(' ').append(NameSyntax.format(element.name()));
        }
        element.type().header().ifPresent(p -> header.append(' ').append(element.values().get(p.name()).text()));
        List<String> properties = element.type().properties().stream().filter(element::mustWrite)
                .map(p -> property(p, element.values().get(p.name()))).toList();
        String line = properties.isEmpty() ? header + " {}" : header + " { " + String.join("  ", properties) + " }";
        if (element.children().isEmpty() && line.length() <= MAX_LINE_LENGTH) {
            return line;
        }
        header.append(" {").append(newline);
        properties.forEach(p -> header.append(indent).append("  ").append(p).append(newline));
        element.children().forEach(c -> header.append(block(c, indent + "  ", newline)).append(newline));
        return header.append(indent).append('}').toString();
    }

    /** A property as the file says it, name and value. */
    static String property(Property<?> property, Value value) {
        property.checkValue(value);
        return property.name() + " " + value.text();
    }
}
