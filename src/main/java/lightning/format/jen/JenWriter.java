package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/** Writes scenes from scratch: only what is not the default, one block per line where it fits. */
public final class JenWriter {
    static final int LINE = 110;

    private JenWriter() {}

    /**
     * The text of a scene file that reads back as {@code scene} in every bit.
     *
     * @throws IllegalArgumentException if a texture's file name is none that a scene file can say
     */
    public static String write(Scene scene) {
        List<Element> head = new ArrayList<>(List.of(Element.of(Blocks.PICTURE, scene.picture()),
                Element.of(Blocks.CAMERA, scene.camera()), Element.of(Blocks.WORLD, scene.world())));
        head.removeIf(Element::isInitial);
        var out = new StringBuilder("jen 1\n");
        section(out, head);
        section(out, scene.materials().stream().map(Element::of).toList());
        section(out, scene.nodes().stream().map(Element::of).toList());
        section(out, scene.rig().banks().stream().map(Element::of).toList());
        section(out, scene.lights().stream().map(Element::of).toList());
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
        return write(scene) + '\n' + new ShotText(scene, "\n").block(shot) + '\n';
    }

    private static void section(StringBuilder out, List<Element> elements) {
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
    static String block(Element element, String indent, String newline) {
        var head = new StringBuilder(indent).append(element.type().keyword());
        if (element.type().named()) {
            head.append(' ').append(NameText.of(element.name()));
        }
        element.type().header().ifPresent(p -> head.append(' ').append(element.values().get(p.name()).text()));
        List<String> properties = element.type().properties().stream().filter(element::mustSay)
                .map(p -> property(p, element.values().get(p.name()))).toList();
        String line = properties.isEmpty() ? head + " {}" : head + " { " + String.join("  ", properties) + " }";
        if (element.children().isEmpty() && line.length() <= LINE) {
            return line;
        }
        head.append(" {").append(newline);
        properties.forEach(p -> head.append(indent).append("  ").append(p).append(newline));
        element.children().forEach(c -> head.append(block(c, indent + "  ", newline)).append(newline));
        return head.append(indent).append('}').toString();
    }

    /** A property as the file says it, name and value. */
    static String property(Property<?> property, Value value) {
        property.checkTogether(value);
        return property.name() + " " + value.text();
    }
}
