package lightning.format.jen;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.scene.Bank;
import lightning.scene.FromFile;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Limits;
import lightning.scene.Links;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Node;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.TextureMap;
import lightning.scene.World;

/**
 * Edits of a scene in the words of the file: {@code key.intensity=0.4}, {@code picture.size=640 480}.
 *
 * <p>The part before the point is {@code picture}, {@code camera}, {@code world}, or the name of a light, a
 * bank, a shape, a group or a material, looked for in this order; {@code material:gold} means a material whatever else has
 * its name. A name in double quotes, {@code "key light".intensity=0.4}, is never one of the three words, and may hold a point and an
 * equals sign; {@link NameText} says how. The properties are those of the file, and {@code name} of everything but materials, {@code type} of lights,
 * {@code texture=none} to take a texture away, and {@code bank=none} to take a light out of its bank. The material {@code default} may be edited before it is written. A picture or a mesh that
 * the scene has not read yet can be named where a folder is given, and is looked for as if the scene file were in it. Every method throws an
 * {@link IllegalArgumentException} whose message says in one sentence what is wrong.
 */
public final class PropertyEdit {
    private static final String NAME = "name";
    private static final String MATERIAL = "material:";
    private static final String NONE = "none";
    private static final String PICTURE = "picture";
    private static final String CAMERA = "camera";
    private static final String WORLD = "world";
    /** What stands for parts of the scene that have no names. */
    private static final List<String> OF_SCENE = List.of(PICTURE, CAMERA, WORLD);

    private PropertyEdit() {}

    /**
     * The scene after an assignment.
     *
     * @param assignment {@code target.property=value}
     * @throws IllegalArgumentException if it has another form, if there is no such target or
     *     property, or if the file could not say that value there
     */
    public static Scene apply(Scene scene, String assignment) {
        return apply(scene, assignment, new HeldFiles(scene, Optional.empty()));
    }

    /**
     * The same, with textures from a folder.
     *
     * @param folder where pictures are looked for, as if the scene file were in it
     */
    public static Scene apply(Scene scene, String assignment, Path folder) {
        return apply(scene, assignment, new HeldFiles(scene, Optional.of(folder)));
    }

    private static Scene apply(Scene scene, String assignment, SceneFiles files) {
        Assignment parts = Assignment.of(assignment);
        return set(scene, parts.target, parts.property, parts.value, files);
    }

    /**
     * Why an assignment has no effect on the picture, {@code sun.at has no effect: a directional light has no position}; empty where it
     * has one. The value is kept all the same, and acts once the light is of another type.
     *
     * @param scene      the scene after the edit
     * @param assignment as {@link #apply(Scene, String)} took it
     */
    public static Optional<String> unused(Scene scene, String assignment) {
        Assignment parts = Assignment.of(assignment);
        return LightAttribute.ALL.stream().filter(a -> a.name().equals(parts.property)).findFirst()
                .flatMap(a -> scene.light(parts.light()).flatMap(light -> a.obstacle(light.type())))
                .map(why -> parts.target + "." + parts.property + " has no effect: " + why);
    }

    /** The parts of {@code target.property=value}. */
    private record Assignment(String target, String property, String value) {
        /** @throws IllegalArgumentException if the text has another form */
        static Assignment of(String text) {
            int name = nameEnd(text);
            int equals = text.indexOf('=', name);
            int point = name > 0 ? name : text.lastIndexOf('.', Math.max(equals, 0));
            if (point < 1 || equals < point || text.charAt(point) != '.') {
                throw new IllegalArgumentException("an edit must be written as NAME.PROPERTY=VALUE, was " + Quote.of(text));
            }
            return new Assignment(text.substring(0, point).strip(), text.substring(point + 1, equals).strip(),
                    text.substring(equals + 1).strip());
        }

        /** The name of the light that it would be of; empty where it is of something else by its form. */
        String light() {
            return OF_SCENE.contains(target) || target.startsWith(MATERIAL) ? "" : NameText.read(target);
        }
    }

    /** The place behind a name in quotes that an assignment begins with; 0 where its name has none. */
    private static int nameEnd(String assignment) {
        int start = assignment.startsWith(MATERIAL) ? MATERIAL.length() : 0;
        return assignment.startsWith("\"", start) ? NameText.closing(assignment, start) + 1 : 0;
    }

    /**
     * The scene with one property set.
     *
     * @param value as the file writes it
     * @throws IllegalArgumentException as {@link #apply(Scene, String)}
     */
    public static Scene set(Scene scene, String target, String property, String value) {
        return set(scene, target, property, value, new HeldFiles(scene, Optional.empty()));
    }

    /**
     * The scene with a picture, read from a file, on a material; how often it repeats is kept.
     *
     * @param folder where the picture is looked for, as if the scene file were in it
     * @throws IllegalArgumentException if there is no such material, or no such picture
     */
    public static Scene picture(Scene scene, String material, MaterialAttribute<Optional<TextureMap>> attribute, String file, Path folder) {
        FileName.check(attribute.name(), file, TextureFolder.NAME);
        return set(scene, MATERIAL + NameText.of(material), attribute.name(), new Value.Quoted(file).text(),
                new HeldFiles(scene, Optional.of(folder)));
    }

    /**
     * The scene with what a file holds on a light: a picture that it projects, or its profile.
     *
     * @param file   its name; empty for none
     * @param folder where it is looked for, as if the scene file were in it
     * @throws IllegalArgumentException if there is no such light, or no such file
     */
    public static <F extends FromFile> Scene file(Scene scene, String light, LightAttribute<Optional<F>> attribute, String file,
            Path folder) {
        return file(scene, NameText.of(light), attribute.name(), file, folder);
    }

    /** The same of the environment around the scene. */
    public static Scene environment(Scene scene, String file, Path folder) {
        return file(scene, WORLD, World.ENVIRONMENT.name(), file, folder);
    }

    private static Scene file(Scene scene, String target, String property, String file, Path folder) {
        if (file.isEmpty()) {
            return set(scene, target, property, NONE);
        }
        FileName.check(property, file, TextureFolder.NAME);
        return set(scene, target, property, new Value.Quoted(file).text(), new HeldFiles(scene, Optional.of(folder)));
    }

    /** What stands for a material where a property is set. */
    public static String target(Material material) {
        return MATERIAL + NameText.of(material.name());
    }

    /** The value of a light's attribute as the file writes it, and as {@link #set(Scene, String, String, String)} reads it. */
    public static String text(Light light, LightAttribute<?> attribute) {
        return text(Element.of(light), attribute.name());
    }

    /** The same of a material's property. */
    public static String text(Material material, String property) {
        return text(Element.of(material), property);
    }

    /** The same of a shape's or a group's. */
    public static String text(Node node, String property) {
        return text(Element.of(node), property);
    }

    private static String text(Element element, String property) {
        Value value = element.values().get(property);
        return value == null || value instanceof Value.Absent ? NONE : value.text();
    }

    private static Scene set(Scene scene, String target, String property, String value, SceneFiles files) {
        return switch (target) {
            case PICTURE -> scene.withPicture(edited(files, Blocks.PICTURE, "", scene.picture(), property, value));
            case CAMERA -> scene.withCamera(edited(files, Blocks.CAMERA, "", scene.camera(), property, value));
            case WORLD -> scene.withWorld(edited(files, Blocks.WORLD, "", scene.world(), property, value));
            default -> target.startsWith(MATERIAL)
                    ? setMaterial(scene, NameText.read(target.substring(MATERIAL.length())), property, value, files)
                    : setNamed(scene, NameText.read(target), property, value, files);
        };
    }

    /**
     * The scene with one more light or bank, the last.
     *
     * @param text a block as in the file, {@code light fill point { intensity 0.5 }} or {@code bank left {}}, or a light in short,
     *     {@code fill point intensity=0.5 at=0 1 2}, the name in quotes where it is no word
     * @throws IllegalArgumentException if the text is not one right light or bank, or its name is taken
     */
    public static Scene add(Scene scene, String text) {
        String block = hasBrace(text) ? text : block(text);
        var problems = new Problems();
        Tokens tokens = Lexer.tokens(block, problems);
        List<Block> blocks = Parser.fragment(tokens, problems);
        throwIfAny(problems);
        if (blocks.size() != 1 || blocks.getFirst().type != Blocks.LIGHT && blocks.getFirst().type != Blocks.BANK) {
            throw new IllegalArgumentException("expected one light, as in 'fill point intensity=0.5', found " + Quote.of(text));
        }
        Optional<Scene> added =
                new SceneBuilder(tokens, problems, LoadedFiles.of(Path.of("")), scene.rig().banks(), scene.stage()).build(blocks);
        throwIfAny(problems);
        Rig more = added.orElseThrow().rig();
        return blocks.getFirst().type == Blocks.BANK ? scene.withRig(scene.rig().plus(more.banks().getLast()))
                : scene.withLights(Stream.concat(scene.lights().stream(), more.lights().stream()).toList());
    }

    /**
     * The scene without a light, or without a bank, whose lights stay.
     *
     * @param light its name, in quotes or without
     * @throws IllegalArgumentException if there is no such light or bank
     */
    public static Scene delete(Scene scene, String light) {
        String name = NameText.read(light);
        if (scene.rig().bank(name).isPresent()) {
            return scene.withRig(scene.rig().without(name));
        }
        List<String> names = Stream.concat(scene.lights().stream().map(Light::name), scene.rig().banks().stream().map(Bank::name))
                .toList();
        if (!names.contains(name)) {
            throw new IllegalArgumentException("there is no light " + Quote.of(name) + Nearest.hint(name, names));
        }
        return scene.withLights(scene.lights().stream().filter(l -> !l.name().equals(name)).toList());
    }

    private static boolean hasBrace(String text) {
        Tokens tokens = Lexer.tokens(text, new Problems());
        return IntStream.range(0, tokens.size()).anyMatch(i -> tokens.kind(i) == Tokens.Kind.OPEN);
    }

    private static String block(String text) {
        String light = text.strip();
        int name = NameText.isQuoted(light) ? NameText.closing(light, 0) + 1 : 0;
        String[] words = light.substring(name).strip().split("\\s+", name > 0 ? 2 : 3);
        int type = name > 0 ? 0 : 1;
        if (words.length <= type || words[type].isEmpty()) {
            throw new IllegalArgumentException("expected a light's name and type, as in 'fill point', found " + Quote.of(text));
        }
        return "light " + (name > 0 ? light.substring(0, name) : words[0]) + " " + words[type] + " { "
                + (words.length <= type + 1 ? "" : words[type + 1].replace('=', ' ')) + "\n}";
    }

    private static Scene setNamed(Scene scene, String target, String property, String value, SceneFiles files) {
        Optional<Light> light = scene.light(target);
        if (light.isPresent()) {
            Light edited = edited(files, Blocks.LIGHT, target, light.get(), property, value);
            checkLinks(scene, edited.illuminates());
            checkLinks(scene, edited.shadowedBy());
            return scene.withLights(replaced(scene.lights(), l -> l == light.get() ? edited : l));
        }
        Optional<Bank> bank = scene.rig().bank(target);
        if (bank.isPresent()) {
            Bank edited = edited(files, Blocks.BANK, target, bank.get(), property, value);
            return scene.withRig(edited.name().equals(target) ? scene.rig().with(edited) : scene.rig().renamed(target, edited.name()));
        }
        Optional<Node> node = scene.stage().node(target);
        if (node.isPresent()) {
            return scene.withNode(target, node(files, node.get(), target, property, value));
        }
        if (scene.material(target).isPresent()) {
            return setMaterial(scene, target, property, value, files);
        }
        List<String> known = Stream.of(OF_SCENE.stream(), scene.lights().stream().map(Light::name),
                scene.rig().banks().stream().map(Bank::name), names(scene.nodes()), scene.materials().stream().map(Material::name))
                .flatMap(s -> s).filter(k -> !k.equals(target))
                .toList();
        throw new IllegalArgumentException("the scene has nothing named " + Quote.of(target) + Nearest.hint(target, known));
    }

    private static void checkLinks(Scene scene, Links links) {
        for (String name : links.names()) {
            if (!scene.stage().hasNode(name)) {
                throw new IllegalArgumentException("there is no shape or group " + Quote.of(name)
                        + Nearest.hint(name, names(scene.nodes()).toList()));
            }
        }
    }

    private static Scene setMaterial(Scene scene, String name, String property, String value, SceneFiles files) {
        Material material = scene.materialsByName().get(name);
        if (material == null) {
            List<String> known = scene.materials().stream().map(Material::name).toList();
            throw new IllegalArgumentException("there is no material " + Quote.of(name) + Nearest.hint(name, known));
        }
        MaterialAttribute.ALL.stream().filter(a -> a.name().equals(property)).findFirst().flatMap(a -> a.obstacle(material.model()))
                .ifPresent(why -> {
                    throw new IllegalArgumentException("material " + Quote.of(name) + ": " + why);
                });
        Material edited = edited(files, Blocks.MATERIAL, name, material, property, value);
        // Another model keeps the colour.
        return scene.withMaterial(edited.model() == material.model() ? edited : material.withModel(edited.model()));
    }

    private static Node node(SceneFiles files, Node node, String target, String property, String value) {
        return switch (node) {
            case Group g -> edited(files, Blocks.GROUP, target, g, property, value);
            case Shape s -> edited(files, Blocks.of(s.solid()), target, s, property, value);
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
    private static <T> T edited(SceneFiles files, BlockType<T> type, String name, T record, String property,
            String value) {
        Map<String, Value> values = new HashMap<>(type.values(record));
        String newName = name;
        if (property.equals(NAME) && type.named() && type != Blocks.MATERIAL) {
            newName = Limits.name(NameText.read(value));
        } else if (canBeNone(type, property) && value.equals(NONE)) {
            values.put(property, new Value.Absent());
        } else {
            values.put(property, value(type, name, property, value));
        }
        for (PictureProperty picture : PictureProperty.ALL) {
            if (picture.repeat().filter(property::equals).isPresent() && values.get(picture.name()) instanceof Value.Absent) {
                throw new IllegalArgumentException("material " + Quote.of(name) + ": " + picture.missing());
            }
        }
        type.properties().forEach(p -> values.computeIfPresent(p.name(), (n, v) -> v instanceof Value.Absent ? p.initial() : v));
        List<Node> children = record instanceof Group g ? g.children() : List.of();
        try {
            return type.builder().build(newName, new Values(values::get, files), children);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException((name.isEmpty() ? type.keyword() : type.keyword() + " " + Quote.of(name)) + ": "
                    + e.getMessage(), e);
        }
    }

    /** Whether {@code none} takes the property away; in quotes it is a name as any other. */
    private static boolean canBeNone(BlockType<?> type, String property) {
        return type == Blocks.WORLD && property.equals(World.ENVIRONMENT.name())
                || type == Blocks.LIGHT && (property.equals(LightAttribute.BANK.name()) || property.equals(LightAttribute.PROFILE.name()))
                || (type == Blocks.LIGHT || type == Blocks.MATERIAL)
                        && PictureProperty.ALL.stream().anyMatch(p -> p.name().equals(property));
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
            throw new IllegalArgumentException(block.title() + ": unknown property " + Quote.of(property) + ", expected one of "
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
        return block.entry(property).value();
    }

    private static void throwIfAny(Problems problems) {
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException(String.join("; ", problems.messages()));
        }
    }
}
