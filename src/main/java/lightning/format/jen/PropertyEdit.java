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
import lightning.scene.World;
import lightning.scene.asset.FileAsset;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeLinks;

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
    /** Targets for parts of the scene without names. */
    private static final List<String> SCENE_TARGETS = List.of(PICTURE, INDIRECT, CAMERA, WORLD);

    private PropertyEdit() {}

    /**
     * Returns the scene after an assignment.
     *
     * @param assignment {@code target.property=value}
     * @throws RefusalException if it has another form, there is no such target or property, or the value is invalid
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
         * @throws RefusalException if the text has another form
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
     * @throws RefusalException as {@link #apply(Scene, String)}
     */
    public static Scene set(Scene scene, String target, String property, String value) {
        return set(scene, target, property, value, new SceneAssets(scene, Optional.empty()));
    }

    /**
     * Returns the scene with an image file on a material; its repeat is kept.
     *
     * @param folder folder that the image is resolved against
     * @throws RefusalException if the material or the image does not exist
     */
    public static Scene setTexture(Scene scene, String material, MaterialAttribute<Optional<TextureMap>> attribute, String file,
            Path folder) {
        FileName.check(attribute.name(), file, TextureFolder.NAME);
        return set(scene, MATERIAL + NameSyntax.format(material), attribute.name(), new Value.Quoted(file).text(),
                new SceneAssets(scene, Optional.of(folder)));
    }

    /**
     * Returns the scene with a file on a light: a gobo, a profile or a texture.
     *
     * @param file file name; empty for none
     * @param folder folder that the file is resolved against
     * @throws RefusalException if the light or the file does not exist
     */
    public static <F extends FileAsset> Scene setFile(Scene scene, String light, LightAttribute<Optional<F>> attribute, String file,
            Path folder) {
        return setFile(scene, NameSyntax.format(light), attribute.name(), file, folder);
    }

    private static Scene setFile(Scene scene, String target, String property, String file, Path folder) {
        if (file.isEmpty()) {
            return set(scene, target, property, NONE);
        }
        FileName.check(property, file, TextureFolder.NAME);
        return set(scene, target, property, new Value.Quoted(file).text(), new SceneAssets(scene, Optional.of(folder)));
    }

    /** Returns the target that addresses a material in an assignment. */
    public static String target(Material material) {
        return MATERIAL + NameSyntax.format(material.name());
    }

    /** Returns the target that addresses an environment in an assignment. */
    public static String target(Dome dome) {
        return dome.isOwn() ? WORLD : DOME + NameSyntax.format(dome.name());
    }

    /** Returns the scene with the image of an environment; empty file name for none. */
    public static Scene setImage(Scene scene, Dome dome, String file, Path folder) {
        return setFile(scene, target(dome), Dome.ENVIRONMENT.name(), file, folder);
    }

    /** Returns the value of a light's attribute in file syntax, as read by {@link #set(Scene, String, String, String)}. */
    public static String text(Light light, LightAttribute<?> attribute) {
        return text(BlockContent.of(light), attribute.name());
    }

    /** Returns the value of a material's property in file syntax. */
    public static String text(Material material, String property) {
        return text(BlockContent.of(material), property);
    }

    /** Returns the value of a property of a shape or group in file syntax. */
    public static String text(SceneNode node, String property) {
        return text(BlockContent.of(node), property);
    }

    static String text(BlockContent element, String property) {
        Value value = element.values().get(property);
        return value == null || value instanceof Value.Absent ? NONE : value.text();
    }

    private static Scene set(Scene scene, String target, String property, String value, AssetSource files) {
        return switch (target) {
            case PICTURE -> scene.withPicture(editProperty(files, BlockTypes.PICTURE, "", scene.picture(), property, value));
            case INDIRECT -> scene.withPicture(scene.picture().withIndirect(Optional.of(editProperty(files, BlockTypes.INDIRECT, "",
                    scene.picture().indirect().orElse(IndirectSettings.DEFAULT), property, value))));
            case CAMERA -> scene.withCamera(editProperty(files, BlockTypes.CAMERA, "", scene.camera(), property, value));
            case WORLD ->
                    scene.withWorld(
                            editProperty(SceneAssets.replacing(files, scene.world().own().image()), BlockTypes.WORLD, "", scene.world(),
                                    property, value).withNamed(scene.world().named()));
            default -> target.startsWith(DOME) ? setDome(scene, NameSyntax.parse(target.substring(DOME.length())), property, value, files)
                    : target.startsWith(MATERIAL)
                            ? setMaterial(scene, NameSyntax.parse(target.substring(MATERIAL.length())), property, value, files)
                    : setNamed(scene, NameSyntax.parse(target), property, value, files);
        };
    }

    /**
     * Returns the scene with a light, bank or dome added at the end.
     *
     * @param text a block as in the file, {@code light fill point { intensity 0.5 }}, {@code bank left {}} or {@code dome sky {}}, or a light in
     *     short form, {@code fill point intensity=0.5 at=0 1 2}, its name in quotes unless it is a word
     * @throws RefusalException if the text is not one valid light, bank or dome, or its name is in use
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
     * @throws RefusalException if there is no such light, bank or dome
     */
    public static Scene delete(Scene scene, String light) {
        String name = NameSyntax.parse(light);
        if (scene.rig().lightGroup(name).isPresent()) {
            return scene.withRig(scene.rig().removeLightGroup(name));
        }
        if (scene.world().dome(name).isPresent()) {
            return scene.withWorld(scene.world().withNamed(scene.world().named().stream().filter(d -> !d.name().equals(name)).toList()));
        }
        List<String> names = Stream.of(scene.lights().stream().map(Light::name), scene.rig().lightGroups().stream().map(LightGroup::name),
                scene.world().named().stream().map(Dome::name)).flatMap(s -> s).toList();
        if (!names.contains(name)) {
            throw new RefusalException("there is no light " + Quote.of(name) + NameSuggestion.hint(name, names));
        }
        return scene.withLights(scene.lights().stream().filter(l -> !l.name().equals(name)).toList());
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

    private static Scene setNamed(Scene scene, String target, String property, String value, AssetSource files) {
        Optional<Light> light = scene.light(target);
        if (light.isPresent()) {
            Light edited = editProperty(files, BlockTypes.LIGHT, target, light.get(), property, value);
            checkLinks(scene, edited.illuminates());
            checkLinks(scene, edited.shadowedBy());
            checkNames(scene, edited.contribution().gains().names());
            return edited.name().equals(target) ? scene.withLight(edited) : scene.renameLight(target, edited.name());
        }
        Optional<LightGroup> group = scene.rig().lightGroup(target);
        if (group.isPresent()) {
            LightGroup edited = editProperty(files, BlockTypes.LIGHT_GROUP, target, group.get(), property, value);
            return scene
                    .withRig(edited.name().equals(target) ? scene.rig().with(edited) : scene.rig().renameLightGroup(target, edited.name()));
        }
        if (scene.world().dome(target).isPresent()) {
            return setDome(scene, target, property, value, files);
        }
        Optional<SceneNode> node = scene.stage().node(target);
        if (node.isPresent()) {
            return scene.withNode(target, editNode(files, node.get(), target, property, value));
        }
        if (scene.material(target).isPresent()) {
            return setMaterial(scene, target, property, value, files);
        }
        List<String> knownNames = Stream.of(SCENE_TARGETS.stream(), scene.lights().stream().map(Light::name),
                scene.rig().lightGroups().stream().map(LightGroup::name), scene.world().named().stream().map(Dome::name),
                nodeNames(scene.nodes()), scene.materials().stream().map(Material::name))
                .flatMap(s -> s).filter(k -> !k.equals(target))
                .toList();
        throw new RefusalException("the scene has nothing named " + Quote.of(target) + NameSuggestion.hint(target, knownNames));
    }

    private static Scene setDome(Scene scene, String name, String property, String value, AssetSource files) {
        Dome dome = scene.world().dome(name).orElseThrow(() -> new RefusalException("there is no dome " + Quote.of(name)
                + NameSuggestion.hint(name, scene.world().named().stream().map(Dome::name).toList())));
        return scene.withWorld(scene.world().withDome(name,
                editProperty(SceneAssets.replacing(files, dome.image()), BlockTypes.DOME, name, dome, property, value)));
    }

    private static void checkLinks(Scene scene, ShapeLinks links) {
        checkNames(scene, links.names());
    }

    private static void checkNames(Scene scene, List<String> names) {
        for (String name : names) {
            if (!scene.stage().hasNode(name)) {
                throw new RefusalException("there is no shape or group " + Quote.of(name)
                        + NameSuggestion.hint(name, nodeNames(scene.nodes()).toList()));
            }
        }
    }

    private static Scene setMaterial(Scene scene, String name, String property, String value, AssetSource files) {
        Material material = scene.materialsByName().get(name);
        if (material == null) {
            List<String> knownNames = scene.materials().stream().map(Material::name).toList();
            throw new RefusalException("there is no material " + Quote.of(name) + NameSuggestion.hint(name, knownNames));
        }
        MaterialAttribute.ALL.stream().filter(a -> a.name().equals(property)).findFirst().flatMap(a -> a.inactiveReason(material.model()))
                .ifPresent(reason -> {
                    throw new RefusalException("material " + Quote.of(name) + ": " + reason);
                });
        Material edited = editProperty(files, BlockTypes.MATERIAL, name, material, property, value);
        // Changing the material model keeps the color.
        return scene.withMaterial(edited.model() == material.model() ? edited : material.withModel(edited.model()));
    }

    private static SceneNode editNode(AssetSource files, SceneNode node, String target, String property, String value) {
        return switch (node) {
            case NodeGroup g -> editProperty(files, BlockTypes.GROUP, target, g, property, value);
            case Shape s -> editProperty(files, BlockTypes.of(s.solid()), target, s, property, value);
        };
    }

    private static Stream<String> nodeNames(List<SceneNode> nodes) {
        return nodes.stream().flatMap(n -> Stream.concat(Stream.of(n.name()),
                n instanceof NodeGroup g ? nodeNames(g.children()) : Stream.empty()));
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
