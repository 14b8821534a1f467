package lightning.format.jen;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.IndirectSettings;
import lightning.scene.NamedCamera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.shot.Shot;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Table of all block types and their properties, which defines the grammar of scene files. */
final class BlockTypes {
    /** Property with the file of a mesh. */
    static final String FILE = "file";
    static final String PART = "part";
    static final String COLORS = "colors";

    /** Block in the braces of {@code picture}. */
    static final BlockType<IndirectSettings> INDIRECT = new BlockType<>("indirect", false, Optional.empty(),
            Property.of(IndirectSettings.ATTRIBUTES),
            (name, v, children) -> v.applyAll(IndirectSettings.DEFAULT, IndirectSettings.ATTRIBUTES));

    static final BlockType<PictureSettings> PICTURE = new BlockType<>("picture", false, Optional.empty(), List.of(
            Property.<PictureSettings>numbers("size", List.of(" width", " height"),
                    Value.of(PictureSettings.DEFAULT.width(), PictureSettings.DEFAULT.height()), 1, SceneLimits.MAX_SIZE, "pixels",
                    p -> Value.of(p.width(), p.height())).asIntegers(),
            Property.of(PictureSettings.DEPTH).getFirst(),
            Property.of(PictureSettings.REFLECTION_RAYS).getFirst(),
            Property.choice("antialias", new Value.Word(SamplingSettings.DEFAULT.antialias().word()), AntialiasMode.WORDS,
                    p -> new Value.Word(p.sampling().antialias().word())),
            Property.<PictureSettings>number("samples", SamplingSettings.DEFAULT.grid(), SceneLimits.MIN_SAMPLES, SceneLimits.MAX_SAMPLES,
                    "along each side of a pixel", p -> (double) p.sampling().grid()).asIntegers(),
            Property.choice("view", new Value.Word(ViewSettings.DEFAULT.curve().word()), ViewCurve.WORDS,
                    p -> new Value.Word(p.view().curve().word())),
            Property.number("exposure", ViewSettings.DEFAULT.exposure(), -ViewSettings.MAX_EXPOSURE, ViewSettings.MAX_EXPOSURE, "stops",
                    p -> p.view().exposure()),
            Property.block(INDIRECT, "diffuse indirect light", PictureSettings::indirect)),
            (name, v, children) -> new PictureSettings(v.integer("size", 0), v.integer("size", 1), v.integer("depth", 0),
                    new SamplingSettings(AntialiasMode.of(v.word("antialias")), v.integer("samples", 0)),
                    v.nested(INDIRECT), new ViewSettings(ViewCurve.of(v.word("view")), v.number("exposure")),
                    v.attributeValue(PictureSettings.REFLECTION_RAYS)));

    static final BlockType<Camera> CAMERA = new BlockType<>("camera", false, Optional.empty(), Property.of(Camera.ATTRIBUTES),
            (name, v, children) -> v.applyAll(Camera.DEFAULT.withView(v.vector("from"), v.vector("to"), v.vector("up")), Camera.OPTICS));

    /** Camera that is kept under a name. */
    static final BlockType<NamedCamera> NAMED_CAMERA = new BlockType<>(CAMERA.keyword(), true, Optional.empty(),
            CAMERA.properties().stream().map(p -> p.<NamedCamera>adapt(NamedCamera::camera)).toList(),
            (name, v, children) -> new NamedCamera(name, CAMERA.builder().build("", v, children)));

    static final BlockType<World> WORLD = new BlockType<>("world", false, Optional.empty(), Property.of(World.ATTRIBUTES),
            (name, v, children) -> v.applyAll(World.DEFAULT, World.ATTRIBUTES));

    static final BlockType<Material> MATERIAL = new BlockType<>("material", true, Optional.empty(),
            MaterialAttribute.ALL.stream().flatMap(a -> Property.of(a).stream().map(p -> p.presentIf(m -> a.appliesTo(m.model()))))
                    .toList(),
            (name, v, children) -> v.applyAll(Material.of(name), MaterialAttribute.ALL));

    private static final BlockType<Shape> MESH = shape("mesh", List.of(
            // A mesh keeps the name of its file even if no file can have it.
            Property.quoted(FILE, "a PLY, OBJ, NFF or glTF file", v -> {},
                    s -> new Value.Quoted(((Solid.TriangleMesh) s.solid()).file())),
            Property.name(PART, new Value.Absent(), "a part of the file; all of it where none is named", BlockTypes::part),
            Property.choice(COLORS, new Value.Word("yes"), List.of("yes", "no"),
                    s -> new Value.Word(((Solid.TriangleMesh) s.solid()).showsColors() ? "yes" : "no"))),
            PropertyValues::triangles);

    static final BlockType<NodeGroup> GROUP = new BlockType<>("group", true, Optional.empty(), placementProperties(),
            (name, v, children) -> new NodeGroup(name, placement(v), children, isVisible(v)));

    static final BlockType<Light> LIGHT = new BlockType<>("light", true, Optional.of(Property.of(LightAttribute.TYPE).getFirst()),
            Property.of(LightAttribute.ALL.stream().filter(a -> a != LightAttribute.TYPE).toList()),
            (name, v, children) -> v.applyAll(Light.of(name, LightType.POINT), LightAttribute.ALL));

    static final BlockType<LightGroup> LIGHT_GROUP = new BlockType<>("bank", true, Optional.empty(), Property.of(LightGroup.ATTRIBUTES),
            (name, v, children) -> v.applyAll(LightGroup.of(name), LightGroup.ATTRIBUTES));

    static final BlockType<Dome> DOME = new BlockType<>("dome", true, Optional.empty(), Property.of(Dome.ATTRIBUTES),
            (name, v, children) -> v.applyAll(Dome.of(name), Dome.ATTRIBUTES));

    /** Shot settings; the animated blocks follow within the same braces. */
    static final BlockType<Shot> SHOT = new BlockType<>("shot", false, Optional.empty(), List.of(
            Property.<Shot>numbers("frames", List.of(" first", " last"), Value.of(Shot.DEFAULT.first(), Shot.DEFAULT.last()), 0,
                    Shot.MAX_FRAME, "the first not after the last", s -> Value.of(s.first(), s.last())).asIntegers(),
            Property.number("rate", Shot.DEFAULT.rate(), Shot.MIN_RATE, Shot.MAX_RATE, "frames per second", Shot::rate)),
            (name, v, children) -> new Shot(v.integer("frames", 0), v.integer("frames", 1), v.number("rate"), List.of()));

    /** Block types of shapes, in document order. */
    private static final List<BlockType<Shape>> SHAPES =
            Stream.concat(Solid.CANONICAL.stream().map(BlockTypes::shape), Stream.of(MESH)).toList();
    private static final Map<String, BlockType<Shape>> SHAPES_BY_NOUN =
            SHAPES.stream().collect(Collectors.toUnmodifiableMap(BlockType::keyword, b -> b));
    private static final Map<String, BlockType<?>> BY_KEYWORD = Stream
            .concat(SHAPES.stream(), Stream.of(PICTURE, CAMERA, WORLD, MATERIAL, GROUP, LIGHT_GROUP, LIGHT, DOME, SHOT))
            .collect(Collectors.toUnmodifiableMap(BlockType::keyword, b -> b));

    /** Keywords of all blocks. */
    static final List<String> KEYWORDS = BY_KEYWORD.keySet().stream().sorted().toList();
    /** Keywords of the blocks allowed in a group. */
    static final List<String> NODE_KEYWORDS = Stream.concat(SHAPES.stream(), Stream.of(GROUP)).map(BlockType::keyword).toList();

    /** Keywords of the blocks allowed in a shot, which can be animated. */
    static final List<String> KEYED_KEYWORDS =
            Stream.concat(Stream.of(CAMERA, WORLD, LIGHT, LIGHT_GROUP, DOME).map(BlockType::keyword), NODE_KEYWORDS.stream()).toList();

    private BlockTypes() {}

    /** Returns the type of the block that is a property's value. */
    static BlockType<?> nested(Property<?> property) {
        if (!property.name().equals(INDIRECT.keyword())) {
            throw new IllegalArgumentException(property.name() + " is no block");
        }
        return INDIRECT;
    }

    static Optional<BlockType<?>> of(String keyword) {
        return Optional.ofNullable(BY_KEYWORD.get(keyword));
    }

    /** Returns the type of the block that describes an element, which the scene must have if it is a shape or group. */
    // A type of elements has one type of records, but shapes and groups.
    @SuppressWarnings("unchecked")
    static <T> BlockType<T> of(Scene scene, SceneElement<T> element) {
        return (BlockType<T>) switch (element) {
            case SceneElement.OfPicture _ -> PICTURE;
            case SceneElement.OfIndirect _ -> INDIRECT;
            case SceneElement.OfCamera _ -> CAMERA;
            case SceneElement.OfWorld _ -> WORLD;
            case SceneElement.OfLight _ -> LIGHT;
            case SceneElement.OfLightGroup _ -> LIGHT_GROUP;
            case SceneElement.OfDome _ -> DOME;
            case SceneElement.OfNode node -> of(node.get(scene));
            case SceneElement.OfMaterial _ -> MATERIAL;
        };
    }

    /** Returns the type of the block of a shape or group. */
    static BlockType<? extends SceneNode> of(SceneNode node) {
        return switch (node) {
            case NodeGroup _ -> GROUP;
            case Shape shape -> of(shape.solid());
        };
    }

    /** Returns the block type of a shape. */
    static BlockType<Shape> of(Solid solid) {
        return requireNonNull(SHAPES_BY_NOUN.get(solid.typeName()));
    }

    private static BlockType<Shape> shape(Solid.Canonical solid) {
        List<Property<Shape>> solidProperties = Property.of(solid.attributes()).stream()
                .map(p -> p.<Shape>adapt(s -> (Solid.Canonical) s.solid())).toList();
        return shape(solid.typeName(), solidProperties, v -> v.applyAll(solid, solid.attributes()));
    }

    /**
     * Creates a shape's block type.
     *
     * @param solidProperties properties of the solid
     */
    private static BlockType<Shape> shape(String noun, List<Property<Shape>> solidProperties, Function<PropertyValues, Solid> solid) {
        Property<Shape> material = Property.name("material", new Value.Name(Material.DEFAULT.name()),
                "the name of a material", s -> new Value.Name(s.material()));
        return new BlockType<>(noun, true, Optional.empty(),
                Stream.of(List.of(material), solidProperties, BlockTypes.<Shape>placementProperties()).flatMap(List::stream).toList(),
                (name, v, children) -> new Shape(solid.apply(v), name, v.name("material"), placement(v), isVisible(v)));
    }

    private static <T extends SceneNode> List<Property<T>> placementProperties() {
        return Property.of(SceneNode.ATTRIBUTES).stream().map(p -> p.<T>adapt(n -> n)).toList();
    }

    private static Value part(Shape mesh) {
        String part = ((Solid.TriangleMesh) mesh.solid()).part();
        return part.isEmpty() ? new Value.Absent() : new Value.Name(part);
    }

    private static boolean isVisible(PropertyValues v) {
        return v.word("visible").equals("yes");
    }

    private static Placement placement(PropertyValues v) {
        return new Placement(v.vector("at"), v.vector("rotate"), v.vector("scale"));
    }
}
