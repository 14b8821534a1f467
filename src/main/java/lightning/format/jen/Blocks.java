package lightning.format.jen;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.scene.Antialias;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Sampling;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.World;
import lightning.scene.shot.Shot;

/** The table of all blocks and their properties: the one place that knows what a file may say. */
final class Blocks {
    /** What a mesh says of the file that it is in. */
    static final String FILE = "file";
    static final String PART = "part";
    static final String COLORS = "colors";

    static final BlockType<Picture> PICTURE = new BlockType<>("picture", false, Optional.empty(), List.of(
            Property.<Picture>numbers("size", List.of(" width", " height"),
                    Value.of(Picture.DEFAULT.width(), Picture.DEFAULT.height()), 1, Limits.MAX_SIZE, "pixels",
                    p -> Value.of(p.width(), p.height())).inWholeNumbers(),
            Property.of(Picture.DEPTH).getFirst(),
            Property.choice("antialias", word(Sampling.DEFAULT.antialias()), words(Antialias.values()),
                    p -> word(p.sampling().antialias())),
            Property.<Picture>number("samples", Sampling.DEFAULT.grid(), Limits.MIN_SAMPLES, Limits.MAX_SAMPLES,
                    "along each side of a pixel", p -> (double) p.sampling().grid()).inWholeNumbers()),
            (name, v, children) -> new Picture(v.whole("size", 0), v.whole("size", 1), v.whole("depth", 0),
                    new Sampling(Antialias.valueOf(v.word("antialias").toUpperCase(Locale.ROOT)), v.whole("samples", 0))));

    static final BlockType<Camera> CAMERA = new BlockType<>("camera", false, Optional.empty(), Property.of(Camera.ATTRIBUTES),
            (name, v, children) -> new Camera(v.vector("from"), v.vector("to"), v.vector("up"), v.number("fov")));

    static final BlockType<World> WORLD = new BlockType<>("world", false, Optional.empty(), Property.of(World.ATTRIBUTES),
            (name, v, children) -> v.on(World.DEFAULT, World.ATTRIBUTES));

    static final BlockType<Material> MATERIAL = new BlockType<>("material", true, Optional.empty(),
            MaterialAttribute.ALL.stream().flatMap(a -> Property.of(a).stream().map(p -> p.where(m -> a.acts(m.model())))).toList(),
            (name, v, children) -> v.on(Material.of(name), MaterialAttribute.ALL));

    private static final BlockType<Shape> MESH = shape("mesh", List.of(
            Property.quoted(FILE, "a PLY, OBJ, NFF or glTF file", v -> FileName.check(FILE, ((Value.Quoted) v).file(), MeshFolder.NAME),
                    s -> new Value.Quoted(((Solid.Triangles) s.solid()).file())),
            Property.name(PART, new Value.Absent(), "a part of the file; all of it where none is named", Blocks::part),
            Property.choice(COLORS, new Value.Word("yes"), List.of("yes", "no"),
                    s -> new Value.Word(((Solid.Triangles) s.solid()).colors() ? "yes" : "no"))),
            Values::triangles);

    static final BlockType<Group> GROUP = new BlockType<>("group", true, Optional.empty(), placed(),
            (name, v, children) -> new Group(name, placement(v), children, visible(v)));

    static final BlockType<Light> LIGHT = new BlockType<>("light", true, Optional.of(Property.of(LightAttribute.TYPE).getFirst()),
            Property.of(LightAttribute.ALL.stream().filter(a -> a != LightAttribute.TYPE).toList()),
            (name, v, children) -> v.on(Light.of(name, LightType.POINT), LightAttribute.ALL));

    static final BlockType<Bank> BANK = new BlockType<>("bank", true, Optional.empty(), Property.of(Bank.ATTRIBUTES),
            (name, v, children) -> v.on(Bank.of(name), Bank.ATTRIBUTES));

    /** The tracks stand in its braces beside these. */
    static final BlockType<Shot> SHOT = new BlockType<>("shot", false, Optional.empty(), List.of(
            Property.<Shot>numbers("frames", List.of(" first", " last"), Value.of(Shot.DEFAULT.first(), Shot.DEFAULT.last()), 0,
                    Shot.MAX_FRAME, "the first not behind the last", s -> Value.of(s.first(), s.last())).inWholeNumbers(),
            Property.number("rate", Shot.DEFAULT.rate(), Shot.MIN_RATE, Shot.MAX_RATE, "frames per second", Shot::rate)),
            (name, v, children) -> new Shot(v.whole("frames", 0), v.whole("frames", 1), v.number("rate"), List.of()));

    /** The blocks of shapes, in the order of the documents. */
    private static final List<BlockType<Shape>> SHAPES =
            Stream.concat(Solid.CANONICAL.stream().map(Blocks::shape), Stream.of(MESH)).toList();
    private static final Map<String, BlockType<Shape>> BY_NOUN =
            SHAPES.stream().collect(Collectors.toUnmodifiableMap(BlockType::keyword, b -> b));
    private static final Map<String, BlockType<?>> BY_KEYWORD = Stream
            .concat(SHAPES.stream(), Stream.of(PICTURE, CAMERA, WORLD, MATERIAL, GROUP, BANK, LIGHT, SHOT))
            .collect(Collectors.toUnmodifiableMap(BlockType::keyword, b -> b));

    /** The keywords of all blocks. */
    static final List<String> KEYWORDS = BY_KEYWORD.keySet().stream().sorted().toList();
    /** The keywords of the blocks that may stand in a group. */
    static final List<String> NODES = Stream.concat(SHAPES.stream(), Stream.of(GROUP)).map(BlockType::keyword).toList();

    /** The keywords of the blocks that may stand in a shot: those of what has keys. */
    static final List<String> KEYED =
            Stream.concat(Stream.of(CAMERA, LIGHT, BANK).map(BlockType::keyword), NODES.stream()).toList();

    private Blocks() {}

    static Optional<BlockType<?>> of(String keyword) {
        return Optional.ofNullable(BY_KEYWORD.get(keyword));
    }

    /** The block of a shape. */
    static BlockType<Shape> of(Solid solid) {
        return BY_NOUN.get(solid.noun());
    }

    private static BlockType<Shape> shape(Solid.Canonical solid) {
        List<Property<Shape>> own = Property.of(solid.attributes()).stream()
                .map(p -> p.<Shape>of(s -> (Solid.Canonical) s.solid())).toList();
        return shape(solid.noun(), own, v -> v.on(solid, solid.attributes()));
    }

    /** @param own the properties of the solid itself */
    private static BlockType<Shape> shape(String noun, List<Property<Shape>> own, Function<Values, Solid> solid) {
        Property<Shape> material = Property.name("material", new Value.Name(Material.DEFAULT.name()),
                "the name of a material", s -> new Value.Name(s.material()));
        return new BlockType<>(noun, true, Optional.empty(),
                Stream.of(List.of(material), own, Blocks.<Shape>placed()).flatMap(List::stream).toList(),
                (name, v, children) -> new Shape(solid.apply(v), name, v.name("material"), placement(v), visible(v)));
    }

    private static <T extends Node> List<Property<T>> placed() {
        return Property.of(Node.ATTRIBUTES).stream().map(p -> p.<T>of(n -> n)).toList();
    }

    private static Value part(Shape mesh) {
        String part = ((Solid.Triangles) mesh.solid()).part();
        return part.isEmpty() ? new Value.Absent() : new Value.Name(part);
    }

    private static boolean visible(Values v) {
        return v.word("visible").equals("yes");
    }

    private static Placement placement(Values v) {
        return new Placement(v.vector("at"), v.vector("rotate"), v.vector("scale"));
    }

    private static Value word(Enum<?> choice) {
        return new Value.Word(choice.name().toLowerCase(Locale.ROOT));
    }

    private static List<String> words(Enum<?>[] choices) {
        return Stream.of(choices).map(c -> c.name().toLowerCase(Locale.ROOT)).toList();
    }
}
