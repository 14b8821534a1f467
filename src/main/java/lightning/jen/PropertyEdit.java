package lightning.jen;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Texture;
import lightning.scene.TextureMap;

/**
 * Edits of a scene in the words of the file: {@code key.intensity=0.4}, {@code picture.size=640 480}.
 *
 * <p>The part before the point is {@code picture}, {@code camera}, {@code world}, or the name of a light, a
 * shape, a group or a material, looked for in this order. The properties are those of the file, and
 * {@code name} of everything but materials, and {@code type} of lights. Every method throws an
 * {@link IllegalArgumentException} whose message says in one sentence what is wrong.
 */
public final class PropertyEdit {
    private static final String NAME = "name";

    private PropertyEdit() {}

    /**
     * The scene after an assignment.
     *
     * @param assignment {@code target.property=value}
     * @throws IllegalArgumentException if it has another form, if there is no such target or
     *     property, or if the file could not say that value there
     */
    public static Scene apply(Scene scene, String assignment) {
        int equals = assignment.indexOf('=');
        int point = assignment.lastIndexOf('.', Math.max(equals, 0));
        if (point < 1) {
            throw new IllegalArgumentException("an edit must be written as NAME.PROPERTY=VALUE, was '" + assignment + "'");
        }
        return set(scene, assignment.substring(0, point).strip(), assignment.substring(point + 1, equals).strip(),
                assignment.substring(equals + 1).strip());
    }

    /**
     * The scene with one property set.
     *
     * @param value as the file writes it
     * @throws IllegalArgumentException as {@link #apply(Scene, String)}
     */
    public static Scene set(Scene scene, String target, String property, String value) {
        switch (target) {
            case "picture" -> {
                return scene.withPicture(edited(scene, Blocks.PICTURE, "", scene.picture(), property, value));
            }
            case "camera" -> {
                return scene.withCamera(edited(scene, Blocks.CAMERA, "", scene.camera(), property, value));
            }
            case "world" -> {
                return scene.withWorld(edited(scene, Blocks.WORLD, "", scene.world(), property, value));
            }
            default -> {
                return setNamed(scene, target, property, value);
            }
        }
    }

    /**
     * The scene with one more light, the last.
     *
     * @param text a block as in the file, {@code light fill point { intensity 0.5 }}, or short,
     *     {@code fill point intensity=0.5 at=0 1 2}
     * @throws IllegalArgumentException if the text is not one right light, or its name is taken
     */
    public static Scene add(Scene scene, String text) {
        String block = text.indexOf('{') >= 0 ? text : block(text);
        var problems = new Problems();
        Tokens tokens = Lexer.tokens(block, problems);
        List<Block> blocks = Parser.fragment(tokens, problems);
        throwIfAny(problems);
        if (blocks.size() != 1 || blocks.getFirst().type != Blocks.LIGHT) {
            throw new IllegalArgumentException("expected one light, as in 'fill point intensity=0.5', found '" + text + "'");
        }
        Optional<Scene> added = new SceneBuilder(tokens, problems, new TextureFolder(Path.of(""))).build(blocks);
        throwIfAny(problems);
        return scene.withLights(Stream.concat(scene.lights().stream(), added.orElseThrow().lights().stream()).toList());
    }

    /**
     * The scene without the light {@code name}.
     *
     * @throws IllegalArgumentException if there is no such light
     */
    public static Scene delete(Scene scene, String name) {
        List<String> names = scene.lights().stream().map(Light::name).toList();
        if (!names.contains(name)) {
            throw new IllegalArgumentException("there is no light '" + name + "'" + Nearest.hint(name, names));
        }
        return scene.withLights(scene.lights().stream().filter(l -> !l.name().equals(name)).toList());
    }

    private static String block(String text) {
        String[] words = text.strip().split("\\s+", 3);
        if (words.length < 2) {
            throw new IllegalArgumentException("expected a light's name and type, as in 'fill point', found '" + text + "'");
        }
        return "light " + words[0] + " " + words[1] + " { " + (words.length < 3 ? "" : words[2].replace('=', ' ')) + "\n}";
    }

    private static Scene setNamed(Scene scene, String target, String property, String value) {
        Optional<Light> light = scene.light(target);
        if (light.isPresent()) {
            Light edited = edited(scene, Blocks.LIGHT, target, light.get(), property, value);
            return scene.withLights(replaced(scene.lights(), l -> l == light.get() ? edited : l));
        }
        if (names(scene.nodes()).anyMatch(target::equals)) {
            List<Node> nodes = replaced(scene.nodes(), n -> node(scene, n, target, property, value));
            return new Scene(scene.picture(), scene.camera(), scene.world(), scene.materials(), nodes, scene.lights());
        }
        if (scene.materials().stream().anyMatch(m -> m.name().equals(target))) {
            List<Material> materials = replaced(scene.materials(), m -> m.name().equals(target)
                    ? edited(scene, Blocks.MATERIAL, target, m, property, value) : m);
            return new Scene(scene.picture(), scene.camera(), scene.world(), materials, scene.nodes(), scene.lights());
        }
        List<String> known = Stream.of(Stream.of("picture", "camera", "world"), scene.lights().stream().map(Light::name),
                names(scene.nodes()), scene.materials().stream().map(Material::name)).flatMap(s -> s).toList();
        throw new IllegalArgumentException("the scene has nothing named '" + target + "'" + Nearest.hint(target, known));
    }

    private static Node node(Scene scene, Node node, String target, String property, String value) {
        if (!node.name().equals(target)) {
            return node instanceof Group g ? new Group(g.name(), g.placement(),
                    replaced(g.children(), n -> node(scene, n, target, property, value))) : node;
        }
        return switch (node) {
            case Group g -> edited(scene, Blocks.GROUP, target, g, property, value);
            case Shape.Sphere s -> edited(scene, Blocks.SPHERE, target, s, property, value);
            case Shape.Cone c -> edited(scene, Blocks.CONE, target, c, property, value);
            case Shape.Cylinder c -> edited(scene, Blocks.CYLINDER, target, c, property, value);
            case Shape.Plane p -> edited(scene, Blocks.PLANE, target, p, property, value);
        };
    }

    private static <T> List<T> replaced(List<T> all, UnaryOperator<T> edit) {
        return all.stream().map(edit).toList();
    }

    private static Stream<String> names(List<Node> nodes) {
        return nodes.stream().flatMap(n -> Stream.concat(Stream.of(n.name()),
                n instanceof Group g ? names(g.children()) : Stream.empty()));
    }

    /** The record with one property set. */
    private static <T> T edited(Scene scene, BlockType<T> type, String name, T record, String property, String value) {
        Map<String, Value> values = new HashMap<>(type.values(record));
        String newName = name;
        if (property.equals(NAME) && type.named() && type != Blocks.MATERIAL) {
            newName = Limits.name(value);
        } else {
            values.put(property, value(type, name, property, value));
        }
        if (property.equals("repeat") && values.get("texture") instanceof Value.Absent) {
            throw new IllegalArgumentException("material '" + name + "': repeat needs a texture, found none");
        }
        type.properties().forEach(p -> values.computeIfPresent(p.name(), (n, v) -> v instanceof Value.Absent ? p.initial() : v));
        List<Node> children = record instanceof Group g ? g.children() : List.of();
        try {
            return type.builder().build(newName, new Values(values, file -> texture(scene, file)), children);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException((name.isEmpty() ? type.keyword() : type.keyword() + " '" + name + "'") + ": "
                    + e.getMessage(), e);
        }
    }

    private static Value value(BlockType<?> type, String name, String property, String text) {
        var problems = new Problems();
        var block = new Block(type, 0);
        block.name = name;
        boolean header = type.header().filter(p -> p.name().equals(property)).isPresent();
        if (!header && type.property(property).isEmpty()) {
            List<String> known = new ArrayList<>(type.propertyNames());
            type.header().ifPresent(p -> known.add(p.name()));
            if (type.named() && type != Blocks.MATERIAL) {
                known.add(NAME);
            }
            throw new IllegalArgumentException(block.title() + ": unknown property '" + property + "', expected one of "
                    + String.join(", ", known) + Nearest.hint(property, known));
        }
        Tokens tokens = Lexer.tokens(header ? text : property + " " + text, problems);
        var parser = new PropertyParser(tokens, problems);
        int end = header ? parser.header(block, type.header().orElseThrow(), 0) : parser.property(block, 0);
        if (tokens.kind(end) != Tokens.Kind.END) {
            problems.add(tokens.start(end), block.title() + ": expected nothing behind the value of " + property + ", found "
                    + tokens.found(end));
        }
        throwIfAny(problems);
        return block.entries.get(property).value();
    }

    /** A picture that the scene already holds: an edit reads no files. */
    private static Texture texture(Scene scene, String file) {
        return scene.materials().stream().flatMap(m -> m.texture().stream()).filter(t -> t.file().equals(file))
                .map(TextureMap::image).findFirst().orElseThrow(() -> new IllegalArgumentException(
                        "texture must be one that the scene already has, was '" + file + "'"));
    }

    private static void throwIfAny(Problems problems) {
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException(String.join("; ", problems.messages()));
        }
    }
}
