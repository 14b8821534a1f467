package lightning.format.jen;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.AssetFolders;
import lightning.format.jen.asset.AssetSource;
import lightning.format.jen.asset.FileName;
import lightning.format.jen.asset.NameSuggestion;
import lightning.format.jen.asset.TextureFolder;
import lightning.scene.Dome;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.value.SceneLimits;

/**
 * Scene edits in the syntax of the scene file: {@code key.intensity=0.4}, {@code picture.size=640 480}.
 *
 * <p>The part before the dot is {@code picture}, {@code picture.indirect}, {@code camera}, {@code world}, or the name of a
 * light, a bank, a dome, a shape, a group or a material, resolved in this order; {@code material:gold} always means a material, {@code
 * dome:sky} a dome. A
 * name in double quotes, {@code "key light".intensity=0.4}, is never one of these four words and may contain a dot and an
 * equals sign; see {@link NameSyntax}.
 *
 * <p>The properties are those of the file, {@code name} of everything but materials, {@code type} of lights, {@code
 * texture=none} to remove a texture, {@code bank=none} to remove a light from its bank, and {@code picture.indirect=none} to
 * switch off indirect light. An edit of {@code picture.indirect} switches it on. The material {@code default} can
 * be edited before it is written. An image or a mesh that the scene has not loaded can be named if a folder is given, which
 * it is resolved against. Every method throws an {@link IllegalArgumentException} with a one-sentence message if the edit is
 * invalid.
 */
public final class PropertyEdit {
    private static final String NAME = "name";
    static final String MATERIAL = "material:";
    private static final String NONE = "none";
    static final String DOME = "dome:";
    static final String PICTURE = "picture";
    static final String INDIRECT = "picture.indirect";
    static final String CAMERA = "camera";
    static final String WORLD = "world";
    /** Blocks that can be added alone. */
    private static final List<BlockType<?>> ADDED = List.of(BlockTypes.LIGHT, BlockTypes.LIGHT_GROUP, BlockTypes.DOME);
    /** Types of elements that can be deleted. */
    private static final List<Class<?>> DELETABLE =
            List.of(SceneElement.OfLight.class, SceneElement.OfLightGroup.class, SceneElement.OfDome.class);
    /** Targets for parts of the scene without names. */
    private static final List<String> SCENE_TARGETS = List.of(PICTURE, INDIRECT, CAMERA, WORLD);

    private PropertyEdit() {}

    /**
     * Returns the scene after an assignment.
     *
     * @param assignment {@code target.property=value}
     * @throws IllegalArgumentException if it has another form, there is no such target or property, or the value is invalid
     */
    public static Scene apply(Scene scene, String assignment) {
        return apply(scene, assignment, new SceneAssets(scene, Optional.empty()));
    }

    /**
     * Returns the scene after an assignment, with textures from a folder.
     *
     * @param folder folder that images are resolved against
     */
    public static Scene apply(Scene scene, String assignment, Path folder) {
        return apply(scene, assignment, new SceneAssets(scene, Optional.of(folder)));
    }

    private static Scene apply(Scene scene, String assignment, AssetSource files) {
        Assignment parts = Assignment.of(assignment);
        return set(scene, parts.target, parts.property, parts.value, files);
    }

    /**
     * Returns why an assignment has no effect on the image, such as {@code sun.at has no effect: a directional light has no
     * position}; empty if it has one. The value is stored anyway, and applies once the light has another type.
     *
     * @param scene scene after the edit
     * @param assignment assignment passed to {@link #apply(Scene, String)}
     */
    public static Optional<String> ineffectiveReason(Scene scene, String assignment) {
        Assignment parts = Assignment.of(assignment);
        return LightAttribute.ALL.stream().filter(a -> a.name().equals(parts.property)).findFirst()
                .flatMap(a -> scene.light(parts.lightName()).flatMap(a::inactiveReason))
                .map(reason -> parts.target + "." + parts.property + " has no effect: " + reason);
    }

    /** Parts of {@code target.property=value}. */
    record Assignment(String target, String property, String value) {
        /**
         * Parses an assignment.
         *
         * @throws IllegalArgumentException if the text has another form
         */
        static Assignment of(String text) {
            int name = nameEnd(text);
            int equals = text.indexOf('=', name);
            int dot = name > 0 ? name : text.lastIndexOf('.', Math.max(equals, 0));
            if (dot < 1 || equals < dot || text.charAt(dot) != '.') {
                throw new RefusalException("an edit must be written as NAME.PROPERTY=VALUE, was " + Quote.of(text));
            }
            return new Assignment(text.substring(0, dot).strip(), text.substring(dot + 1, equals).strip(),
                    text.substring(equals + 1).strip());
        }

        /** Returns the name of the light that it may refer to; empty if its form refers to another target. */
        String lightName() {
            return SCENE_TARGETS.contains(target) || target.startsWith(MATERIAL) || target.startsWith(DOME) ? "" : NameSyntax.parse(target);
        }
    }

    /** Returns the offset after a quoted name at the start of an assignment; 0 if the name is not quoted. */
    private static int nameEnd(String assignment) {
        int start = assignment.startsWith(MATERIAL) ? MATERIAL.length() : assignment.startsWith(DOME) ? DOME.length() : 0;
        return assignment.startsWith("\"", start) ? NameSyntax.closingQuote(assignment, start) + 1 : 0;
    }

    /**
     * Returns the scene with one property set.
     *
     * @param value value in file syntax
     * @throws IllegalArgumentException as {@link #apply(Scene, String)}
     */
    public static Scene set(Scene scene, String target, String property, String value) {
        return set(scene, target, property, value, new SceneAssets(scene, Optional.empty()));
    }

    /**
     * Returns the scene with one property of an element set.
     *
     * @param value value in file syntax
     * @throws IllegalArgumentException as {@link #apply(Scene, String)}, and if the scene does not have the element
     */
    public static Scene set(Scene scene, SceneElement<?> element, String property, String value) {
        return set(scene, element, property, value, new SceneAssets(scene, Optional.empty()));
    }

    /**
     * Returns the scene with a file of an element: an image or an IES profile. An image of a material keeps its placement.
     *
     * @param file file name; empty for none
     * @param folder folder that the file is resolved against
     * @throws IllegalArgumentException if the element or the file does not exist
     */
    public static Scene setFile(Scene scene, SceneElement<?> element, String property, String file, Path folder) {
        if (file.isEmpty()) {
            return set(scene, element, property, NONE);
        }
        FileName.check(property, file, TextureFolder.NAME);
        return set(scene, element, property, new Value.Quoted(file).text(), new SceneAssets(scene, Optional.of(folder)));
    }

    /** Returns the value of a property in file syntax, as read by {@link #set(Scene, SceneElement, String, String)}. */
    public static String text(Scene scene, SceneElement<?> element, String property) {
        return text(BlockContent.of(scene, element), property);
    }

    /** Returns the target that addresses an element in an assignment. */
    static String target(SceneElement<?> element) {
        return switch (element) {
            case SceneElement.OfPicture _ -> PICTURE;
            case SceneElement.OfIndirect _ -> INDIRECT;
            case SceneElement.OfCamera _ -> CAMERA;
            case SceneElement.OfWorld _ -> WORLD;
            case SceneElement.OfDome(String name) -> name.equals(Dome.OWN) ? WORLD : DOME + NameSyntax.format(name);
            case SceneElement.OfMaterial(String name) -> MATERIAL + NameSyntax.format(name);
            case SceneElement.OfLight _,SceneElement.OfLightGroup _,SceneElement.OfNode _ -> NameSyntax.format(element.name());
        };
    }

    /**
     * Returns the element that a target addresses.
     *
     * @throws IllegalArgumentException if the scene does not have it
     */
    static SceneElement<?> element(Scene scene, String target) {
        return switch (target) {
            case PICTURE -> SceneElement.PICTURE;
            case INDIRECT -> SceneElement.INDIRECT;
            case CAMERA -> SceneElement.CAMERA;
            case WORLD -> SceneElement.WORLD;
            default -> target.startsWith(DOME) ? existing(scene, new SceneElement.OfDome(NameSyntax.parse(target.substring(DOME.length()))))
                    : target.startsWith(MATERIAL)
                            ? existing(scene, new SceneElement.OfMaterial(NameSyntax.parse(target.substring(MATERIAL.length()))))
                    : named(scene, NameSyntax.parse(target));
        };
    }

    private static SceneElement<?> existing(Scene scene, SceneElement<?> element) {
        if (element.name().isEmpty() || !element.existsIn(scene)) {
            throw new RefusalException("there is no " + element.label() + hint(scene, element.name(), List.of(element.getClass())));
        }
        return element;
    }

    private static SceneElement<?> named(Scene scene, String name) {
        return SceneElement.named(scene, name).orElseThrow(() -> new RefusalException("the scene has nothing named "
                + Quote.of(name) + NameSuggestion.hint(name, Stream.concat(SCENE_TARGETS.stream(),
                        SceneElement.named(scene).map(SceneElement::name))
                        .filter(known -> !known.equals(name)).toList())));
    }

    /** Returns a hint about a similar name of an element of one of the types. */
    private static String hint(Scene scene, String name, List<? extends Class<?>> types) {
        return NameSuggestion.hint(name, SceneElement.named(scene).filter(e -> types.contains(e.getClass()))
                .map(SceneElement::name).toList());
    }

    static String text(BlockContent element, String property) {
        Value value = element.values().get(property);
        return value == null || value instanceof Value.Absent ? NONE : value.text();
    }

    private static Scene set(Scene scene, String target, String property, String value, AssetSource files) {
        return set(scene, element(scene, target), property, value, files);
    }

    // An element that is matched by its type has its type of records.
    @SuppressWarnings("unchecked")
    private static <T> Scene set(Scene scene, SceneElement<T> element, String property, String value, AssetSource files) {
        T before = element instanceof SceneElement.OfIndirect
                ? (T) scene.picture().indirect().orElse(IndirectSettings.DEFAULT) : element.get(scene);
        Optional<Environment> replaced = before instanceof World world ? world.own().image()
                : before instanceof Dome dome ? dome.image() : Optional.empty();
        if (before instanceof Material material) {
            checkModel(material, property);
        }
        T edited = editProperty(SceneAssets.replacing(files, replaced), BlockTypes.of(scene, element), element.name(), before, property,
                value);
        if (edited instanceof Light light) {
            checkNames(scene, light.illuminates().names());
            checkNames(scene, light.shadowedBy().names());
            checkNames(scene, light.influence().gains().names());
        }
        return element.with(scene, edited instanceof World world ? (T) world.withNamed(scene.world().named())
                // Changing the material model keeps the color.
                : before instanceof Material old && edited instanceof Material material && material.model() != old.model()
                        ? (T) old.withModel(material.model())
                : edited);
    }

    /**
     * Returns the scene with a light, bank or dome added at the end.
     *
     * @param text a block as in the file, {@code light fill point { intensity 0.5 }}, {@code bank left {}} or {@code dome sky {}}, or a light in
     *     short form, {@code fill point intensity=0.5 at=0 1 2}, its name in quotes unless it is a word
     * @throws IllegalArgumentException if the text is not one valid light, bank or dome, or its name is in use
     */
    public static Scene add(Scene scene, String text) {
        String block = hasBrace(text) ? text : lightBlock(text);
        var problems = new ProblemList();
        TokenList tokens = Lexer.tokens(block, problems);
        List<Block> blocks = Parser.parseFragment(tokens, problems);
        throwIfAny(problems);
        if (blocks.size() != 1 || !ADDED.contains(blocks.getFirst().type)) {
            throw new RefusalException("expected one light, such as 'fill point intensity=0.5', found " + Quote.of(text));
        }
        Optional<Scene> added =
                new SceneBuilder(tokens, problems, FileNotes.asProblems(problems), AssetFolders.of(Path.of("")), scene.rig().lightGroups(),
                        scene.stage()).build(blocks);
        throwIfAny(problems);
        LightRig addedRig = added.orElseThrow().rig();
        List<Dome> addedDomes = added.orElseThrow().world().named();
        if (!addedDomes.isEmpty()) {
            return scene.withWorld(scene.world().withNamed(Stream.concat(scene.world().named().stream(), addedDomes.stream()).toList()));
        }
        return blocks.getFirst().type == BlockTypes.LIGHT_GROUP ? scene.withRig(scene.rig().addLightGroup(addedRig.lightGroups().getLast()))
                : scene.withLights(Stream.concat(scene.lights().stream(), addedRig.lights().stream()).toList());
    }

    /**
     * Returns the scene without a light, a dome, or a bank, whose lights remain.
     *
     * @param light name, with or without quotes
     * @throws IllegalArgumentException if there is no such light, bank or dome
     */
    public static Scene delete(Scene scene, String light) {
        String name = NameSyntax.parse(light);
        return SceneElement.named(scene, name).filter(element -> DELETABLE.contains(element.getClass())).orElseThrow(
                () -> new RefusalException("there is no light " + Quote.of(name) + hint(scene, name, DELETABLE))).delete(scene);
    }

    private static boolean hasBrace(String text) {
        TokenList tokens = Lexer.tokens(text, new ProblemList());
        return IntStream.range(0, tokens.size()).anyMatch(i -> tokens.kind(i) == TokenList.Kind.OPEN);
    }

    private static String lightBlock(String text) {
        String light = text.strip();
        int name = NameSyntax.isQuoted(light) ? NameSyntax.closingQuote(light, 0) + 1 : 0;
        String[] words = light.substring(name).strip().split("\\s+", name > 0 ? 2 : 3);
        int type = name > 0 ? 0 : 1;
        if (words.length <= type || words[type].isEmpty()) {
            throw new RefusalException("expected a light's name and type, such as 'fill point', found " + Quote.of(text));
        }
        return "light " + (name > 0 ? light.substring(0, name) : words[0]) + " " + words[type] + " { "
                + (words.length <= type + 1 ? "" : words[type + 1].replace('=', ' ')) + "\n}";
    }

    private static void checkNames(Scene scene, List<String> names) {
        for (String name : names) {
            if (!scene.stage().hasNode(name)) {
                throw new RefusalException("there is no shape or group " + Quote.of(name)
                        + hint(scene, name, List.of(SceneElement.OfNode.class)));
            }
        }
    }

    private static void checkModel(Material material, String property) {
        MaterialAttribute.ALL.stream().filter(a -> a.name().equals(property)).findFirst().flatMap(a -> a.inactiveReason(material.model()))
                .ifPresent(reason -> {
                    throw new RefusalException("material " + Quote.of(material.name()) + ": " + reason);
                });
    }

    /** Returns the record with one property set. */
    private static <T> T editProperty(AssetSource files, BlockType<T> type, String name, T record, String property,
            String value) {
        Map<String, Value> values = new HashMap<>(type.values(record));
        String newName = name;
        if (property.equals(NAME) && type.isNamed() && type != BlockTypes.MATERIAL) {
            newName = SceneLimits.checkName(NameSyntax.parse(value));
        } else if (canBeNone(type, property) && value.equals(NONE)) {
            values.put(property, new Value.Absent());
        } else {
            values.put(property, parseValue(type, name, property, value));
        }
        for (TextureProperty picture : TextureProperty.of(type)) {
            if (picture.dependents().contains(property) && values.get(picture.name()) instanceof Value.Absent) {
                throw new RefusalException("material " + Quote.of(name) + ": " + picture.missingMessage(property));
            }
        }
        type.properties().forEach(p -> values.computeIfPresent(p.name(), (n, v) -> v instanceof Value.Absent ? p.initial() : v));
        List<SceneNode> children = record instanceof NodeGroup g ? g.children() : List.of();
        try {
            return type.builder().build(newName, new PropertyValues(values::get, files), children);
        } catch (RefusalException e) {
            throw new RefusalException((name.isEmpty() ? type.keyword() : type.keyword() + " " + Quote.of(name)) + ": "
                    + e.getMessage(), e);
        }
    }

    /** Returns whether an unquoted {@code none} removes the property. */
    private static boolean canBeNone(BlockType<?> type, String property) {
        return type == BlockTypes.PICTURE && property.equals(BlockTypes.INDIRECT.keyword())
                || (type == BlockTypes.WORLD || type == BlockTypes.DOME) && property.equals(World.ENVIRONMENT.name())
                || type == BlockTypes.LIGHT
                        && (property.equals(LightAttribute.LIGHT_GROUP.name()) || property.equals(LightAttribute.PROFILE.name())
                                || property.equals(LightAttribute.GAINS.name()) || property.equals(LightAttribute.SHAPE.name()))
                || type == BlockTypes.MATERIAL && property.equals(MaterialAttribute.BULB.name())
                || TextureProperty.of(type).stream().anyMatch(p -> p.name().equals(property));
    }

    private static Value parseValue(BlockType<?> type, String name, String property, String text) {
        var problems = new ProblemList();
        var block = new Block(type, 0);
        block.name = name;
        boolean isHeader = type.header().filter(p -> p.name().equals(property)).isPresent();
        if (!isHeader && type.property(property).isEmpty()) {
            List<String> knownNames = new ArrayList<>(type.propertyNames());
            type.header().ifPresent(p -> knownNames.add(p.name()));
            if (type.isNamed() && type != BlockTypes.MATERIAL) {
                knownNames.add(NAME);
            }
            throw new RefusalException(block.title() + ": unknown property " + Quote.of(property) + ", expected one of "
                    + String.join(", ", knownNames) + NameSuggestion.hint(property, knownNames));
        }
        TokenList tokens = Lexer.tokens(isHeader ? text : property + " " + text, problems);
        var parser = new PropertyParser(tokens, problems);
        int end = isHeader ? parser.parseHeader(block, type.header().orElseThrow(), 0) : parser.parseProperty(block, 0);
        if (tokens.kind(end) != TokenList.Kind.END) {
            problems.add(tokens.start(end), block.title() + ": expected nothing after the value of " + property + ", found "
                    + tokens.describe(end));
        }
        throwIfAny(problems);
        return requireNonNull(block.entry(property)).value();
    }

    private static void throwIfAny(ProblemList problems) {
        if (!problems.isEmpty()) {
            throw new RefusalException(String.join("; ", problems.messages()));
        }
    }
}
