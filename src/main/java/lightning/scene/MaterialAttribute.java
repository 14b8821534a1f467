package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.base.math.Rgb;
import lightning.base.text.Texts;

/** The attributes of materials, each described here and nowhere else, in the order in which a file writes them. */
public final class MaterialAttribute<V> extends Attribute<Material, V> {

    /** What people find together, in this order. */
    public enum Section {
        MODEL,
        DIFFUSE,
        BASE,
        TEXTURE,
        CUTOUT,
        RELIEF,
        SPECULAR,
        SURFACE,
        REFLECTIVE,
        CLEAR,
        AMBIENT
    }

    private static final List<MaterialAttribute<?>> DECLARED = new ArrayList<>();

    public static final MaterialAttribute<Rgb> AMBIENT = color("ambient", Limits.MAX_EMISSION, Rgb.BLACK, Material::ambient,
            Material::withAmbient, null, Section.AMBIENT, "What the surface shows without a light: times the scene's ambience, 0 or more");
    public static final MaterialAttribute<SurfaceModel> MODEL = new MaterialAttribute<>("model", Choice.of(SurfaceModel.class),
            SurfaceModel.PHONG, "", Material::model, Material::withModel, MaterialTerm.MODEL, null, Section.MODEL,
            "By which equation the surface answers light: the paper's, or that of base colour, metalness and roughness");
    public static final MaterialAttribute<Rgb> DIFFUSE = color("diffuse", 1, Rgb.grey(0.8), Material::diffuse,
            Material::withDiffuse, SurfaceModel.PHONG, Section.DIFFUSE,
            "The light that the surface scatters; times the texture where there is one");
    public static final MaterialAttribute<Rgb> BASE = color("base", 1, Rgb.grey(0.8), Material::base, Material::withBase,
            SurfaceModel.METALLIC, Section.BASE,
            "What the surface scatters, or mirrors where it is a metal; times the texture where there is one");
    public static final MaterialAttribute<Optional<TextureMap>> TEXTURE =
            new MaterialAttribute<>("texture", new ValueKind.Texturing("repeat", SampleMeaning.COLOR),
                    Optional.empty(), "", Material::texture, Material::withTexture, MaterialTerm.TEXEL, null, Section.TEXTURE,
                    "The picture on the surface");
    public static final MaterialAttribute<Optional<TextureMap>> CUTOUT = cutout("cutout",
            new ValueKind.Texturing("cutout_repeat", SampleMeaning.OPACITY), Optional.empty(), "", Cutout::cutout, Cutout::withCutout,
            "A picture of what is there, by its alpha, or by its luminance where it has none: the rest is cut out");
    public static final MaterialAttribute<Double> CUTOFF = cutout("cutoff", Quantity.number(0, 1, 0.05), 0.5, "", Cutout::cutoff,
            Cutout::withCutoff, "Where less than this is there by the cutout picture, the surface is cut out");
    public static final MaterialAttribute<Optional<TextureMap>> BUMP =
            relief("bump", "bump", new ValueKind.Texturing("bump_repeat", SampleMeaning.NUMBER),
                    Optional.empty(), "", Relief::bump, Relief::withBump, "A picture of heights: white is above black");
    public static final MaterialAttribute<Double> HEIGHT = relief("height", "height",
            Quantity.number(-Limits.MAX_HEIGHT, Limits.MAX_HEIGHT, 0.01), 0.05, "scene units, of white above black", Relief::height,
            Relief::withHeight, "How much higher the bump picture's white is than its black");
    public static final MaterialAttribute<Optional<TextureMap>> NORMALS = relief("normal_map", "normals",
            new ValueKind.Texturing("normal_repeat", SampleMeaning.NUMBER), Optional.empty(), "", Relief::normals, Relief::withNormals,
            "A picture of normals, as glTF has them");
    public static final MaterialAttribute<Double> STRENGTH = relief("strength", "strength",
            Quantity.number(-Limits.MAX_STRENGTH, Limits.MAX_STRENGTH, 0.1), 1.0, "factor on how far normals lean", Relief::strength,
            Relief::withStrength, "How far the normals of the picture of normals lean");
    public static final MaterialAttribute<Rgb> SPECULAR = color("specular", 1, Rgb.BLACK, Material::specular,
            Material::withSpecular, SurfaceModel.PHONG, Section.SPECULAR, "The colour of highlights; black for none");
    public static final MaterialAttribute<Double> SHININESS = number("shininess", Limits.MAX_SHININESS, 1, 16, "exponent",
            Material::shininess, Material::withShininess, MaterialTerm.HIGHLIGHT, SurfaceModel.PHONG, Section.SPECULAR,
            "How small highlights are");
    public static final MaterialAttribute<Double> METALNESS = number("metalness", 1, 0.1, 0, "", Material::metalness,
            Material::withMetalness, MaterialTerm.COLOR, SurfaceModel.METALLIC, Section.SURFACE,
            "How far the surface is a metal: 0 for none, 1 for one");
    public static final MaterialAttribute<Double> ROUGHNESS = number("roughness", 1, 0.05, 0.5, "", Material::roughness,
            Material::withRoughness, MaterialTerm.HIGHLIGHT, SurfaceModel.METALLIC, Section.SURFACE,
            "How wide highlights are: 0 for a smooth surface");
    public static final MaterialAttribute<Double> F0 = number("f0", 1, 0.01, 0.04, "part of the light head-on", Material::f0,
            Material::withF0, MaterialTerm.COLOR, SurfaceModel.METALLIC, Section.SURFACE,
            "Which part of the light a surface that is no metal mirrors head-on: 0.02 for water, 0.04 for plastic, 0.17 for diamond");
    public static final MaterialAttribute<Rgb> REFLECTIVE = color("reflective", 1, Rgb.BLACK, Material::reflective,
            Material::withReflective, null, Section.REFLECTIVE, "How much the surface mirrors; black for no mirror");

    public static final MaterialAttribute<Rgb> CLEAR = color("clear", 1, Rgb.BLACK, m -> m.clarity().clear(),
            (m, v) -> m.withClarity(m.clarity().withClear(v)), null, Section.CLEAR,
            "The colour of what is seen through the surface; black where nothing is");
    public static final MaterialAttribute<Double> IOR = clarity("ior", "ior", Quantity.number(1, Limits.MAX_IOR, 0.01), 1.5,
            "index of refraction", Clarity::ior, Clarity::withIor, MaterialTerm.REFRACTION,
            "How far rays bend where they pass: 1.33 for water, 1.5 for glass, 2.42 for diamond");
    public static final MaterialAttribute<Boolean> THIN = clarity("thin", "thin", Choice.YES_OR_NO, false, "", Clarity::thin,
            Clarity::withThin, MaterialTerm.REFRACTION,
            "Whether the surface is a pane, which bends no ray and has no inside");
    public static final MaterialAttribute<Rgb> TINT = color("tint", 1, Rgb.WHITE, m -> m.clarity().tint(),
            (m, v) -> m.withClarity(m.clarity().withTint(v)), null, Section.CLEAR,
            "What is left of white after the tint distance inside");
    public static final MaterialAttribute<Double> TINT_DISTANCE = clarity("tint_distance", "tint distance",
            Quantity.number(Limits.MIN_TINT_DISTANCE, Limits.MAX_TINT_DISTANCE, 0.1), 1.0, "scene units", Clarity::tintDistance,
            Clarity::withTintDistance, MaterialTerm.COLOR, "The way inside after which white has become the tint");
    public static final MaterialAttribute<ShadowsThrown> SHADOWS = clarity("shadows", "shadows", Choice.of(ShadowsThrown.class),
            ShadowsThrown.FULL, "", Clarity::shadows, Clarity::withShadows, MaterialTerm.SHADOW,
            "Which shadows shapes of the material throw: full ones, those of the colour of the light that passes, or none");

    /** All of them, as they are declared above; that which decides about others before these. */
    public static final List<MaterialAttribute<?>> ALL = List.copyOf(DECLARED);

    private final ValueKind.OfMaterial<V> kind;
    private final MaterialTerm term;
    /** The only one by which it acts; null where it acts by all. */
    private final SurfaceModel model;
    private final Section section;
    private final String help;

    private MaterialAttribute(String name, ValueKind.OfMaterial<V> kind, V initial, String unit, Function<Material, V> get,
            BiFunction<Material, V, Material> with, MaterialTerm term, SurfaceModel model, Section section, String help) {
        this(name, name, kind, initial, unit, get, with, term, model, section, help);
    }

    private MaterialAttribute(String name, String title, ValueKind.OfMaterial<V> kind, V initial, String unit, Function<Material, V> get,
            BiFunction<Material, V, Material> with, MaterialTerm term, SurfaceModel model, Section section, String help) {
        super(name, title, kind, initial, unit, get, with);
        this.kind = kind;
        this.term = term;
        this.model = model;
        this.section = section;
        this.help = help;
        DECLARED.add(this);
    }

    private static MaterialAttribute<Rgb> color(String name, double max, Rgb initial, Function<Material, Rgb> get,
            BiFunction<Material, Rgb, Material> with, SurfaceModel model, Section section, String help) {
        return new MaterialAttribute<>(name, Quantity.color(max), initial, "linear red, green, blue", get, with, MaterialTerm.COLOR,
                model, section, help);
    }

    private static MaterialAttribute<Double> number(String name, double max, double step, double initial, String unit,
            Function<Material, Double> get, BiFunction<Material, Double, Material> with, MaterialTerm term, SurfaceModel model,
            Section section, String help) {
        return new MaterialAttribute<>(name, Quantity.number(0, max, step), initial, unit, get, with, term, model, section, help);
    }

    /** Whether it acts on a material of this model; else it has its initial value there. */
    public boolean acts(SurfaceModel of) {
        return model == null || model == of;
    }

    /** Why a material of this model does not have it: a clause; empty where it acts. */
    public Optional<String> obstacle(SurfaceModel of) {
        return acts(of) ? Optional.empty()
                : Optional.of(Texts.of("a material of model {0} has no {1}", MODEL.kind().text(of), Texts.of(title())));
    }

    /**
     * The value as a material of this model has it.
     *
     * @throws IllegalArgumentException if no record may have the value; the message says why
     */
    V checked(SurfaceModel of, V value) {
        check(value);
        return acts(of) ? value : initial();
    }

    private static <V> MaterialAttribute<V> relief(String name, String title, ValueKind.OfMaterial<V> kind, V initial, String unit,
            Function<Relief, V> get, BiFunction<Relief, V, Relief> with, String help) {
        return new MaterialAttribute<>(name, title, kind, initial, unit, m -> get.apply(m.relief()),
                (m, v) -> m.withRelief(with.apply(m.relief(), v)), MaterialTerm.NORMAL, null, Section.RELIEF, help);
    }

    private static <V> MaterialAttribute<V> cutout(String name, ValueKind.OfMaterial<V> kind, V initial, String unit,
            Function<Cutout, V> get,
            BiFunction<Cutout, V, Cutout> with, String help) {
        return new MaterialAttribute<>(name, kind, initial, unit, m -> get.apply(m.cutout()),
                (m, v) -> m.withCutout(with.apply(m.cutout(), v)), MaterialTerm.PRESENCE, null, Section.CUTOUT, help);
    }

    private static <V> MaterialAttribute<V> clarity(String name, String title, ValueKind.OfMaterial<V> kind, V initial, String unit,
            Function<Clarity, V> get, BiFunction<Clarity, V, Clarity> with, MaterialTerm term, String help) {
        return new MaterialAttribute<>(name, title, kind, initial, unit, m -> get.apply(m.clarity()),
                (m, v) -> m.withClarity(with.apply(m.clarity(), v)), term, null, Section.CLEAR, help);
    }

    /** Colours are alike where they are as floats, which rows are coloured with. */
    @Override
    public boolean isAlike(Material a, Material b) {
        return super.isAlike(a, b) || of(a) instanceof Rgb before && of(b) instanceof Rgb after && sameFloats(before, after);
    }

    private static boolean sameFloats(Rgb a, Rgb b) {
        return (float) a.r() == (float) b.r() && (float) a.g() == (float) b.g() && (float) a.b() == (float) b.b();
    }

    @Override
    public ValueKind.OfMaterial<V> kind() {
        return kind;
    }

    /** What it changes. */
    public MaterialTerm term() {
        return term;
    }

    public Section section() {
        return section;
    }

    /** What it does, a sentence without a full stop. */
    public String help() {
        return help;
    }
}
