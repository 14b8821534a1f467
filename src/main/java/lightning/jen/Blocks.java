package lightning.jen;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Antialias;
import lightning.scene.Attenuation;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Sampling;
import lightning.scene.Shape;
import lightning.scene.TextureMap;
import lightning.scene.World;

/** The table of all blocks and their properties: the one place that knows what a file may say. */
final class Blocks {
    static final BlockType<Picture> PICTURE = new BlockType<>("picture", false, Optional.empty(), List.of(
            Property.<Picture>numbers("size", List.of(" width", " height"),
                    Value.of(Picture.DEFAULT.width(), Picture.DEFAULT.height()), 1, Limits.MAX_SIZE, "pixels",
                    p -> Value.of(p.width(), p.height())).inWholeNumbers(),
            Property.<Picture>number("depth", Picture.DEFAULT.depth(), 0, Limits.MAX_DEPTH, "mirror bounces",
                    p -> (double) p.depth()).inWholeNumbers(),
            Property.choice("antialias", word(Sampling.DEFAULT.antialias()), words(Antialias.values()),
                    p -> word(p.sampling().antialias())),
            Property.<Picture>number("samples", Sampling.DEFAULT.grid(), Limits.MIN_SAMPLES, Limits.MAX_SAMPLES,
                    "along each side of a pixel", p -> (double) p.sampling().grid()).inWholeNumbers()),
            (name, v, children) -> new Picture(v.whole("size", 0), v.whole("size", 1), v.whole("depth", 0),
                    new Sampling(Antialias.valueOf(v.word("antialias").toUpperCase(Locale.ROOT)), v.whole("samples", 0))));

    static final BlockType<Camera> CAMERA = new BlockType<>("camera", false, Optional.empty(), List.of(
            position("from", Camera.DEFAULT.from(), Camera::from),
            position("to", Camera.DEFAULT.to(), Camera::to),
            direction("up", Camera.DEFAULT.up(), Camera::up),
            Property.number("fov", Camera.DEFAULT.fov(), Limits.MIN_FOV, Limits.MAX_FOV, "degrees, vertical", Camera::fov)),
            (name, v, children) -> new Camera(v.vector("from"), v.vector("to"), v.vector("up"), v.number("fov")));

    static final BlockType<World> WORLD = new BlockType<>("world", false, Optional.empty(), List.of(
            Property.number("ambience", World.DEFAULT.ambience(), 0, Limits.MAX_AMBIENCE, "", World::ambience),
            color("background", World.DEFAULT.background(), Limits.MAX_EMISSION, World::background)),
            (name, v, children) -> new World(v.number("ambience"), v.color("background")));

    static final BlockType<Material> MATERIAL = new BlockType<>("material", true, Optional.empty(), List.of(
            color("ambient", Material.DEFAULT.ambient(), Limits.MAX_EMISSION, Material::ambient),
            color("diffuse", Material.DEFAULT.diffuse(), 1, Material::diffuse),
            Property.quoted("texture", "a PNG or JPEG file", v -> TextureName.check(((Value.Quoted) v).file()),
                    m -> texture(m, t -> new Value.Quoted(t.file()))),
            Property.<Material>numbers("repeat", List.of(" u", " v"), Value.of(1, 1), -Limits.MAX_REPEAT,
                    Limits.MAX_REPEAT, "times, needs a texture", m -> texture(m, t -> Value.of(t.repeatU(), t.repeatV())))
                    .also(v -> new TextureMap("", component(v, 0), component(v, 1), null)),
            color("specular", Material.DEFAULT.specular(), 1, Material::specular),
            Property.number("shininess", Material.DEFAULT.shininess(), 0, Limits.MAX_SHININESS, "exponent",
                    Material::shininess),
            color("reflective", Material.DEFAULT.reflective(), 1, Material::reflective)),
            (name, v, children) -> new Material(name, v.color("ambient"), v.color("diffuse"), v.color("specular"),
                    v.number("shininess"), v.color("reflective"), textureMap(v)));

    static final BlockType<Shape.Sphere> SPHERE =
            shape("sphere", (name, v, children) -> new Shape.Sphere(name, v.name("material"), placement(v)));
    static final BlockType<Shape.Cone> CONE =
            shape("cone", (name, v, children) -> new Shape.Cone(name, v.name("material"), placement(v)));
    static final BlockType<Shape.Cylinder> CYLINDER =
            shape("cylinder", (name, v, children) -> new Shape.Cylinder(name, v.name("material"), placement(v)));
    static final BlockType<Shape.Plane> PLANE =
            shape("plane", (name, v, children) -> new Shape.Plane(name, v.name("material"), placement(v)));

    static final BlockType<Group> GROUP = new BlockType<>("group", true, Optional.empty(), placed(),
            (name, v, children) -> new Group(name, placement(v), children));

    static final BlockType<Light> LIGHT = new BlockType<>("light", true,
            Optional.of(Property.choice("type", word(LightType.POINT), words(LightType.values()), l -> word(l.type()))),
            lightProperties(Light.of("initial", LightType.POINT)),
            (name, v, children) -> new Light(name, LightType.valueOf(v.word("type").toUpperCase(Locale.ROOT)),
                    v.color("color"), v.number("intensity"), v.vector("at"), v.vector("direction"),
                    new Attenuation(v.number("attenuation", 0), v.number("attenuation", 1), v.number("attenuation", 2)),
                    v.number("angle"), v.number("dropoff"), v.yes("on"), v.yes("solo")));

    private static final Map<String, BlockType<?>> BY_KEYWORD = Stream.of(PICTURE, CAMERA, WORLD, MATERIAL, SPHERE, CONE,
            CYLINDER, PLANE, GROUP, LIGHT).collect(Collectors.toUnmodifiableMap(BlockType::keyword, b -> b));

    /** The keywords of all blocks. */
    static final List<String> KEYWORDS = BY_KEYWORD.keySet().stream().sorted().toList();
    /** The keywords of the blocks that may stand in a group. */
    static final List<String> NODES = List.of("sphere", "cone", "cylinder", "plane", "group");

    private Blocks() {}

    static Optional<BlockType<?>> of(String keyword) {
        return Optional.ofNullable(BY_KEYWORD.get(keyword));
    }

    private static List<Property<Light>> lightProperties(Light initial) {
        return List.of(
                color("color", initial.color(), Limits.MAX_LIGHT_COLOR, Light::color),
                Property.number("intensity", initial.intensity(), 0, Limits.MAX_INTENSITY, "", Light::intensity),
                position("at", initial.position(), Light::position),
                direction("direction", initial.direction(), Light::direction),
                Property.numbers("attenuation", List.of(" constant", " linear", " quadratic"),
                        attenuation(initial.attenuation()), 0, Limits.MAX_ATTENUATION,
                        "per scene unit to the power 0, 1, 2", l -> attenuation(l.attenuation())),
                Property.number("angle", initial.angle(), 0, Limits.MAX_ANGLE, "degrees from the axis", Light::angle),
                Property.number("dropoff", initial.dropoff(), 0, Limits.MAX_DROPOFF, "exponent", Light::dropoff),
                Property.yes("on", initial.on(), Light::on),
                Property.yes("solo", initial.solo(), Light::solo));
    }

    private static <T extends Shape> BlockType<T> shape(String keyword, BlockType.Builder<T> builder) {
        Property<T> material = Property.name("material", new Value.Name(Material.DEFAULT.name()),
                "the name of a material", s -> new Value.Name(s.material()));
        return new BlockType<>(keyword, true, Optional.empty(),
                Stream.concat(Stream.of(material), Blocks.<T>placed().stream()).toList(), builder);
    }

    private static <T extends Node> List<Property<T>> placed() {
        return List.of(
                Blocks.<T>position("at", Vec3.ZERO, n -> n.placement().at()),
                Property.<T>vector("rotate", Value.of(Vec3.ZERO), Limits.MAX_ROTATION,
                        "degrees about x, then y, then z", n -> Value.of(n.placement().rotate())),
                Property.<T>vector("scale", Value.of(Vec3.ONE), Limits.MAX_SCALE, "factors, none 0",
                        n -> Value.of(n.placement().scale()))
                        .also(v -> new Placement(Vec3.ZERO, Vec3.ZERO, vector(v))));
    }

    private static Placement placement(Values v) {
        return new Placement(v.vector("at"), v.vector("rotate"), v.vector("scale"));
    }

    private static <T> Property<T> position(String name, Vec3 initial, Function<T, Vec3> get) {
        return Property.vector(name, Value.of(initial), Limits.MAX_COORDINATE, "scene units", t -> Value.of(get.apply(t)));
    }

    private static <T> Property<T> direction(String name, Vec3 initial, Function<T, Vec3> get) {
        return Property.<T>vector(name, Value.of(initial), Limits.MAX_COORDINATE, "any length but 0",
                t -> Value.of(get.apply(t))).also(v -> Limits.direction(name, vector(v)));
    }

    private static <T> Property<T> color(String name, Rgb initial, double max, Function<T, Rgb> get) {
        return Property.color(name, Value.of(initial), max, t -> Value.of(get.apply(t)));
    }

    private static Optional<TextureMap> textureMap(Values v) {
        if (v.has("texture")) {
            String file = v.file("texture");
            return Optional.of(new TextureMap(file, v.number("repeat", 0), v.number("repeat", 1),
                    v.textures().apply(file)));
        }
        return Optional.empty();
    }

    private static Value texture(Material m, Function<TextureMap, Value> get) {
        return m.texture().map(get).orElse(new Value.Absent());
    }

    private static Value attenuation(Attenuation a) {
        return Value.of(a.constant(), a.linear(), a.quadratic());
    }

    private static Value word(Enum<?> choice) {
        return new Value.Word(choice.name().toLowerCase(Locale.ROOT));
    }

    private static List<String> words(Enum<?>[] choices) {
        return Stream.of(choices).map(c -> c.name().toLowerCase(Locale.ROOT)).toList();
    }

    private static double component(Value v, int index) {
        return ((Value.Numbers) v).all().get(index);
    }

    private static Vec3 vector(Value v) {
        return new Vec3(component(v, 0), component(v, 1), component(v, 2));
    }
}
