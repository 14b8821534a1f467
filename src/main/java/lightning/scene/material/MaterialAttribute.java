package lightning.scene.material;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.attribute.AttributePart;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Emission;
import lightning.scene.value.SceneLimits;

/** Attributes of materials, in file order. */
public final class MaterialAttribute<V> extends SceneAttribute<Material, V> {

    /** Section of the attribute in the editor, in this order. */
    public enum Section {
        MODEL,
        DIFFUSE,
        BASE,
        SPECULAR,
        SURFACE,
        TEXTURE,
        REFLECTIVE,
        COAT,
        SHEEN,
        CLEAR(Messages.key("transparency")),
        GLOW,
        RELIEF,
        CUTOUT,
        AMBIENT;

        private final String title;

        Section() {
            title = name().toLowerCase(Locale.ROOT);
        }

        Section(String title) {
            this.title = title;
        }

        public String title() {
            return title;
        }
    }

    private static final Set<ShadingModel> ANY = EnumSet.allOf(ShadingModel.class);
    private static final Set<ShadingModel> PHONG = EnumSet.of(ShadingModel.PHONG);
    private static final Set<ShadingModel> MICROFACETS = EnumSet.of(ShadingModel.METALLIC, ShadingModel.PRINCIPLED);
    private static final Set<ShadingModel> PRINCIPLED = EnumSet.of(ShadingModel.PRINCIPLED);
    /** Models whose surfaces reflect only what an attribute says. */
    private static final Set<ShadingModel> NO_REFLECTIONS = EnumSet.complementOf(EnumSet.of(ShadingModel.PRINCIPLED));
    private static final ChoiceKind<TextureChannel> CHANNELS = ChoiceKind.of(TextureChannel.class)
            .withLabels(List.of(Messages.key("red"), Messages.key("green"), Messages.key("blue")));
    private static final AttributePart<Material, SurfaceMaps> SURFACE_MAPS =
            new AttributePart<>(SurfaceMaps.NONE, Material::surfaceMaps, Material::withSurfaceMaps);
    private static final AttributePart<Material, LayerMaps> LAYER_MAPS =
            new AttributePart<>(LayerMaps.NONE, Material::layerMaps, Material::withLayerMaps);
    private static final AttributePart<Material, Coat> COATS = new AttributePart<>(Coat.NONE, Material::coat, Material::withCoat);
    private static final AttributePart<Material, Sheen> SHEENS = new AttributePart<>(Sheen.NONE, Material::sheen, Material::withSheen);
    private static final AttributePart<Material, Anisotropy> ANISOTROPIES =
            new AttributePart<>(Anisotropy.NONE, Material::anisotropy, Material::withAnisotropy);
    private static final List<MaterialAttribute<?>> REGISTRY = new ArrayList<>();

    public static final MaterialAttribute<Rgb> AMBIENT = colorAttribute("ambient", SceneLimits.MAX_EMISSION, Rgb.BLACK, Material::ambient,
            Material::withAmbient, ANY, Section.AMBIENT, "Color emitted without any light; multiplied by the scene's ambient light");
    public static final MaterialAttribute<Rgb> GLOW = colorAttribute("glow", SceneLimits.MAX_EMISSION, Rgb.BLACK, Material::glow,
            Material::withGlow, ANY, Section.GLOW, "Light that the surface emits itself, independent of the scene's ambient light");
    public static final MaterialAttribute<Optional<TextureMap>> GLOW_MAP = new MaterialAttribute<>("glow_map", "glow map",
            new ValueKind.TextureKind("glow_repeat", TextureUsage.COLOR), Optional.empty(), "", Material::glowMap, Material::withGlowMap,
            MaterialTerm.TEXEL, ANY, Section.GLOW, "Image that multiplies the glow, and that of a bulb");
    public static final MaterialAttribute<String> BULB = new MaterialAttribute<>("bulb", "bulb of",
            new ValueKind.NameKind(ValueKind.NameKind.Referent.LIGHT,
                    Messages.key("Light whose color and intensity the surface shows; the light itself lights the scene")),
            "", "name of a light", m -> m.bulb().light(), (m, v) -> m.withBulb(m.bulb().withLight(v).withGlow(Rgb.BLACK)),
            MaterialTerm.COLOR,
            ANY, Section.GLOW,
            "Light whose color and intensity the surface shows; the light itself lights the scene");
    public static final MaterialAttribute<Double> BULB_EXPOSURE = new MaterialAttribute<>("bulb_exposure", "bulb exposure",
            NumericKind.stops(-Emission.MAX_EXPOSURE, Emission.MAX_EXPOSURE, 0.1), Bulb.NONE.exposure(), "stops",
            m -> m.bulb().exposure(), (m, v) -> m.withBulb(m.bulb().withExposure(v)), MaterialTerm.COLOR, ANY, Section.GLOW,
            "Brightness of the bulb in stops, relative to the intensity of its light");
    public static final MaterialAttribute<ShadingModel> MODEL = new MaterialAttribute<>("model", ChoiceKind.of(ShadingModel.class),
            ShadingModel.PHONG, "", Material::model, Material::withModel, MaterialTerm.MODEL, ANY, Section.MODEL,
            "Shading model: Phong, base color with metalness and roughness, or the same with reflections of the surroundings");
    public static final MaterialAttribute<Rgb> DIFFUSE = colorAttribute("diffuse", 1, Rgb.gray(0.8), Material::diffuse,
            Material::withDiffuse, PHONG, Section.DIFFUSE,
            "Diffuse color; multiplied by the texture, if any");
    public static final MaterialAttribute<Rgb> BASE = colorAttribute("base", 1, Rgb.gray(0.8), Material::base, Material::withBase,
            MICROFACETS, Section.BASE,
            "Diffuse color, or reflection color of a metal; multiplied by the texture, if any");
    public static final MaterialAttribute<Optional<TextureMap>> TEXTURE =
            new MaterialAttribute<>("texture", new ValueKind.TextureKind("repeat", TextureUsage.COLOR),
                    Optional.empty(), "", Material::texture, Material::withTexture, MaterialTerm.TEXEL, ANY, Section.TEXTURE,
                    "Color texture of the surface");
    public static final MaterialAttribute<Optional<TextureMap>> CUTOUT = cutoutAttribute("cutout",
            new ValueKind.TextureKind("cutout_repeat", TextureUsage.OPACITY), Optional.empty(), "", AlphaCutout::map, AlphaCutout::withMap,
            "Opacity map: uses alpha, or luminance if the image has no alpha");
    public static final MaterialAttribute<Double> CUTOFF =
            cutoutAttribute("cutoff", NumericKind.number(0, 1, 0.05), 0.5, "", AlphaCutout::cutoff,
                    AlphaCutout::withCutoff, "Opacity below which the surface is cut out");
    public static final MaterialAttribute<Optional<TextureMap>> BUMP =
            bumpAttribute("bump", "bump", new ValueKind.TextureKind("bump_repeat", TextureUsage.DATA),
                    Optional.empty(), "", BumpMapping::bump, BumpMapping::withBump, "Bump map: white is high, black is low");
    public static final MaterialAttribute<Double> BUMP_HEIGHT = bumpAttribute("height", "height",
            NumericKind.number(-SceneLimits.MAX_HEIGHT, SceneLimits.MAX_HEIGHT, 0.01), 0.05, "scene units, from black to white",
            BumpMapping::height,
            BumpMapping::withHeight, "Height difference between white and black in the bump map");
    public static final MaterialAttribute<Optional<TextureMap>> NORMAL_MAP = bumpAttribute("normal_map", "normals",
            new ValueKind.TextureKind("normal_repeat", TextureUsage.DATA), Optional.empty(), "", BumpMapping::normalMap,
            BumpMapping::withNormalMap,
            "Tangent-space normal map, as in glTF");
    public static final MaterialAttribute<Double> NORMAL_STRENGTH = bumpAttribute("strength", "strength",
            NumericKind.number(-SceneLimits.MAX_STRENGTH, SceneLimits.MAX_STRENGTH, 0.1), 1.0, "scales the normals' tilt",
            BumpMapping::strength,
            BumpMapping::withStrength, "Strength of the normal map");
    public static final MaterialAttribute<Rgb> SPECULAR = colorAttribute("specular", 1, Rgb.BLACK, Material::specular,
            Material::withSpecular, PHONG, Section.SPECULAR, "Color of highlights; black for none");
    public static final MaterialAttribute<Double> SHININESS = numberAttribute("shininess", SceneLimits.MAX_SHININESS, 1, 16, "exponent",
            Material::shininess, Material::withShininess, MaterialTerm.HIGHLIGHT, PHONG, Section.SPECULAR,
            "Phong exponent; higher values give smaller highlights");
    public static final MaterialAttribute<Double> METALNESS = numberAttribute("metalness", 1, 0.1, 0, "", Material::metalness,
            Material::withMetalness, MaterialTerm.COLOR, MICROFACETS, Section.SURFACE,
            "0 for a nonmetal, 1 for a metal");
    public static final MaterialAttribute<Double> ROUGHNESS = numberAttribute("roughness", 1, 0.05, 0.5, "", Material::roughness,
            Material::withRoughness, MaterialTerm.HIGHLIGHT, MICROFACETS, Section.SURFACE,
            "Width of highlights, and blur of reflections; 0 for a smooth surface");
    public static final MaterialAttribute<Optional<TextureMap>> ROUGHNESS_MAP = part(SURFACE_MAPS, "roughness_map", "roughness map",
            new ValueKind.TextureKind("roughness_repeat", TextureUsage.DATA), "", SurfaceMaps::roughness, SurfaceMaps::withRoughness,
            MaterialTerm.HIGHLIGHT_TEXEL, Section.SURFACE, "Image that multiplies the roughness of an opaque material");
    public static final MaterialAttribute<TextureChannel> ROUGHNESS_CHANNEL = part(SURFACE_MAPS, "roughness_channel", "roughness channel",
            CHANNELS, "", SurfaceMaps::roughnessChannel, SurfaceMaps::withRoughnessChannel, MaterialTerm.HIGHLIGHT_TEXEL, Section.SURFACE,
            "Channel of the roughness map that is read; all channels of a gray image are equal");
    public static final MaterialAttribute<Optional<TextureMap>> METALNESS_MAP = part(SURFACE_MAPS, "metalness_map", "metalness map",
            new ValueKind.TextureKind("metalness_repeat", TextureUsage.DATA), "", SurfaceMaps::metalness, SurfaceMaps::withMetalness,
            MaterialTerm.TEXEL, Section.SURFACE, "Image that multiplies the metalness of an opaque material");
    public static final MaterialAttribute<TextureChannel> METALNESS_CHANNEL = part(SURFACE_MAPS, "metalness_channel", "metalness channel",
            CHANNELS, "", SurfaceMaps::metalnessChannel, SurfaceMaps::withMetalnessChannel, MaterialTerm.TEXEL, Section.SURFACE,
            "Channel of the metalness map that is read; all channels of a gray image are equal");
    public static final MaterialAttribute<Double> F0 = numberAttribute("f0", 1, 0.01, 0.04, "reflectance at normal incidence", Material::f0,
            Material::withF0, MaterialTerm.COLOR, MICROFACETS, Section.SURFACE,
            "Reflectance of a nonmetal at normal incidence: 0.02 for water, 0.04 for plastic, 0.17 for diamond");
    public static final MaterialAttribute<Optional<TextureMap>> F0_MAP = part(SURFACE_MAPS, "f0_map", "f0 map",
            new ValueKind.TextureKind("f0_repeat", TextureUsage.DATA), "", SurfaceMaps::f0, SurfaceMaps::withF0, MaterialTerm.TEXEL,
            Section.SURFACE, "Image that multiplies f0 of an opaque material");
    public static final MaterialAttribute<TextureChannel> F0_CHANNEL = part(SURFACE_MAPS, "f0_channel", "f0 channel", CHANNELS, "",
            SurfaceMaps::f0Channel, SurfaceMaps::withF0Channel, MaterialTerm.TEXEL, Section.SURFACE,
            "Channel of the f0 map that is read; all channels of a gray image are equal");
    public static final MaterialAttribute<Rgb> SPECULAR_TINT = new MaterialAttribute<>("specular_tint", "specular tint",
            NumericKind.color(1), Rgb.WHITE, "linear red, green, blue", Material::specularTint, Material::withSpecularTint,
            MaterialTerm.COLOR, PRINCIPLED, Section.SURFACE, "Color of a nonmetal's reflection, seen straight on");
    public static final MaterialAttribute<Optional<TextureMap>> SPECULAR_TINT_MAP = part(SURFACE_MAPS, "specular_tint_map",
            "specular tint map", new ValueKind.TextureKind("specular_tint_repeat", TextureUsage.COLOR), "", SurfaceMaps::specularTint,
            SurfaceMaps::withSpecularTint, MaterialTerm.TEXEL, Section.SURFACE,
            "Image that multiplies the specular tint of an opaque material");
    public static final MaterialAttribute<Double> ANISOTROPY = part(ANISOTROPIES, "anisotropy", "anisotropy",
            NumericKind.number(0, 1, 0.05), "", Anisotropy::strength, Anisotropy::withStrength, MaterialTerm.HIGHLIGHT, Section.SURFACE,
            "Stretch of highlights and reflections, as of brushed metal: 0 for none");
    public static final MaterialAttribute<Double> ANISOTROPY_ROTATION = part(ANISOTROPIES, "anisotropy_rotation", "anisotropy rotation",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), "degrees from the horizontal of the texture",
            Anisotropy::rotation, Anisotropy::withRotation, MaterialTerm.HIGHLIGHT, Section.SURFACE,
            "Direction of the stretch: 0 for the horizontal of the texture, 90 for the vertical");
    public static final MaterialAttribute<Double> COAT = part(COATS, "coat", "coat", NumericKind.number(0, 1, 0.05), "share of the surface",
            Coat::weight, Coat::withWeight, MaterialTerm.HIGHLIGHT, Section.COAT, "Clear layer over the surface, as lacquer: 0 for none");
    public static final MaterialAttribute<Optional<TextureMap>> COAT_MAP = part(LAYER_MAPS, "coat_map", "coat map",
            new ValueKind.TextureKind("coat_repeat", TextureUsage.DATA), "", LayerMaps::coat, LayerMaps::withCoat,
            MaterialTerm.HIGHLIGHT_TEXEL, Section.COAT, "Image that multiplies the coat of an opaque material");
    public static final MaterialAttribute<TextureChannel> COAT_CHANNEL = part(LAYER_MAPS, "coat_channel", "coat channel", CHANNELS, "",
            LayerMaps::coatChannel, LayerMaps::withCoatChannel, MaterialTerm.HIGHLIGHT_TEXEL, Section.COAT,
            "Channel of the coat map that is read; all channels of a gray image are equal");
    public static final MaterialAttribute<Double> COAT_ROUGHNESS = part(COATS, "coat_roughness", "coat roughness",
            NumericKind.number(0, 1, 0.05), "", Coat::roughness, Coat::withRoughness, MaterialTerm.HIGHLIGHT, Section.COAT,
            "Blur of the reflections in the coat; 0 for a smooth one");
    public static final MaterialAttribute<Optional<TextureMap>> COAT_ROUGHNESS_MAP = part(LAYER_MAPS, "coat_roughness_map",
            "coat roughness map", new ValueKind.TextureKind("coat_roughness_repeat", TextureUsage.DATA), "", LayerMaps::coatRoughness,
            LayerMaps::withCoatRoughness, MaterialTerm.HIGHLIGHT_TEXEL, Section.COAT,
            "Image that multiplies the roughness of the coat of an opaque material");
    public static final MaterialAttribute<TextureChannel> COAT_ROUGHNESS_CHANNEL = part(LAYER_MAPS, "coat_roughness_channel",
            "coat roughness channel", CHANNELS, "", LayerMaps::coatRoughnessChannel, LayerMaps::withCoatRoughnessChannel,
            MaterialTerm.HIGHLIGHT_TEXEL, Section.COAT,
            "Channel of the coat roughness map that is read; all channels of a gray image are equal");
    public static final MaterialAttribute<Double> COAT_IOR = part(COATS, "coat_ior", "coat IOR",
            NumericKind.number(1, SceneLimits.MAX_IOR, 0.01), "index of refraction", Coat::ior, Coat::withIor, MaterialTerm.HIGHLIGHT,
            Section.COAT, "Index of refraction of the coat: 1.5 for lacquer");
    public static final MaterialAttribute<Optional<TextureMap>> COAT_NORMAL_MAP = part(LAYER_MAPS, "coat_normal_map", "coat normals",
            new ValueKind.TextureKind("coat_normal_repeat", TextureUsage.DATA), "", LayerMaps::coatNormal, LayerMaps::withCoatNormal,
            MaterialTerm.NORMAL, Section.COAT, "Tangent-space normal map of the coat, which the bumps of the surface do not change");
    public static final MaterialAttribute<Double> COAT_STRENGTH = part(LAYER_MAPS, "coat_strength", "coat strength",
            NumericKind.number(-SceneLimits.MAX_STRENGTH, SceneLimits.MAX_STRENGTH, 0.1), "", LayerMaps::coatStrength,
            LayerMaps::withCoatStrength, MaterialTerm.NORMAL, Section.COAT, "Strength of the normal map of the coat");
    public static final MaterialAttribute<Rgb> SHEEN = part(SHEENS, "sheen", "sheen", NumericKind.color(1), "linear red, green, blue",
            Sheen::color, Sheen::withColor, MaterialTerm.COLOR, Section.SHEEN,
            "Color of fibers that shine near the outline, as those of velvet; black for none");
    public static final MaterialAttribute<Optional<TextureMap>> SHEEN_MAP = part(LAYER_MAPS, "sheen_map", "sheen map",
            new ValueKind.TextureKind("sheen_repeat", TextureUsage.COLOR), "", LayerMaps::sheen, LayerMaps::withSheen, MaterialTerm.TEXEL,
            Section.SHEEN, "Image that multiplies the color of the sheen of an opaque material");
    public static final MaterialAttribute<Double> SHEEN_ROUGHNESS = part(SHEENS, "sheen_roughness", "sheen roughness",
            NumericKind.number(0, 1, 0.05), "", Sheen::roughness, Sheen::withRoughness, MaterialTerm.HIGHLIGHT, Section.SHEEN,
            "Width of the shine: small values keep it at the outline");
    public static final MaterialAttribute<Optional<TextureMap>> SHEEN_ROUGHNESS_MAP = part(LAYER_MAPS, "sheen_roughness_map",
            "sheen roughness map", new ValueKind.TextureKind("sheen_roughness_repeat", TextureUsage.DATA), "", LayerMaps::sheenRoughness,
            LayerMaps::withSheenRoughness, MaterialTerm.HIGHLIGHT_TEXEL, Section.SHEEN,
            "Image that multiplies the roughness of the sheen of an opaque material");
    public static final MaterialAttribute<TextureChannel> SHEEN_ROUGHNESS_CHANNEL = part(LAYER_MAPS, "sheen_roughness_channel",
            "sheen roughness channel", CHANNELS, "", LayerMaps::sheenRoughnessChannel, LayerMaps::withSheenRoughnessChannel,
            MaterialTerm.HIGHLIGHT_TEXEL, Section.SHEEN,
            "Channel of the sheen roughness map that is read; all channels of a gray image are equal");
    public static final MaterialAttribute<Rgb> REFLECTIVE = colorAttribute("reflective", 1, Rgb.BLACK, Material::reflective,
            Material::withReflective, NO_REFLECTIONS, Section.REFLECTIVE, "Mirror reflection per channel; black for none");

    public static final MaterialAttribute<Rgb> TRANSMISSION_COLOR = new MaterialAttribute<>("clear", "transparency", NumericKind.color(1),
            Rgb.BLACK, "linear red, green, blue", m -> m.transmission().color(),
            (m, v) -> m.withTransmission(m.transmission().withColor(v)),
            MaterialTerm.COLOR, ANY, Section.CLEAR, "Transmission color; black for an opaque surface");
    public static final MaterialAttribute<Double> IOR =
            transmissionAttribute("ior", "IOR", NumericKind.number(1, SceneLimits.MAX_IOR, 0.01), 1.5,
                    "index of refraction", Transmission::ior, Transmission::withIor, MaterialTerm.REFRACTION,
                    "Index of refraction: 1.33 for water, 1.5 for glass, 2.42 for diamond");
    public static final MaterialAttribute<Boolean> THIN =
            transmissionAttribute("thin", "thin", ChoiceKind.YES_OR_NO, false, "", Transmission::thin,
                    Transmission::withThin, MaterialTerm.REFRACTION,
                    "Thin sheet: does not refract and has no interior");
    public static final MaterialAttribute<Rgb> TINT = colorAttribute("tint", 1, Rgb.WHITE, m -> m.transmission().tint(),
            (m, v) -> m.withTransmission(m.transmission().withTint(v)), ANY, Section.CLEAR,
            "Color of white light after the tint distance inside the material");
    public static final MaterialAttribute<Double> TINT_DISTANCE = transmissionAttribute("tint_distance", "tint distance",
            NumericKind.number(SceneLimits.MIN_TINT_DISTANCE, SceneLimits.MAX_TINT_DISTANCE, 0.1), 1.0, "scene units",
            Transmission::tintDistance,
            Transmission::withTintDistance, MaterialTerm.COLOR, "Distance inside the material after which white light has the tint color");
    public static final MaterialAttribute<ShadowCasting> SHADOWS =
            transmissionAttribute("shadows", "shadows",
                    ChoiceKind.of(ShadowCasting.class)
                            .withLabels(List.of(Messages.key("opaque"), Messages.key("tinted"), Messages.key("off"), Messages.key("only"))),
                    ShadowCasting.FULL, "", Transmission::shadows, Transmission::withShadows, MaterialTerm.SHADOW,
                    "Shadows of objects with this material: opaque, tinted by the transmitted color, off, or only: a blocker that is not seen");

    /** All attributes, in declaration order; the model comes before the attributes that depend on it. */
    public static final List<MaterialAttribute<?>> ALL = List.copyOf(REGISTRY);
    /** Attributes whose values are images. */
    public static final List<MaterialAttribute<Optional<TextureMap>>> MAPS = ALL.stream().flatMap(a -> a.asMap().stream()).toList();

    private final ValueKind.MaterialKind<V> kind;
    private final MaterialTerm term;
    /** Shading models that have it. */
    private final Set<ShadingModel> models;
    private final Section section;
    private final String help;

    private MaterialAttribute(String name, ValueKind.MaterialKind<V> kind, V initial, String unit, Function<Material, V> get,
            BiFunction<Material, V, Material> with, MaterialTerm term, Set<ShadingModel> models, Section section, String help) {
        this(name, name, kind, initial, unit, get, with, term, models, section, help);
    }

    private MaterialAttribute(String name, String title, ValueKind.MaterialKind<V> kind, V initial, String unit, Function<Material, V> get,
            BiFunction<Material, V, Material> with, MaterialTerm term, Set<ShadingModel> models, Section section, String help) {
        super(name, title, kind, initial, unit, get, with);
        this.kind = kind;
        this.term = term;
        this.models = models;
        this.section = section;
        this.help = help;
        REGISTRY.add(this);
    }

    private static MaterialAttribute<Rgb> colorAttribute(String name, double max, Rgb initial, Function<Material, Rgb> get,
            BiFunction<Material, Rgb, Material> with, Set<ShadingModel> models, Section section, String help) {
        return new MaterialAttribute<>(name, NumericKind.color(max), initial, "linear red, green, blue", get, with, MaterialTerm.COLOR,
                models, section, help);
    }

    private static MaterialAttribute<Double> numberAttribute(String name, double max, double step, double initial, String unit,
            Function<Material, Double> get, BiFunction<Material, Double, Material> with, MaterialTerm term, Set<ShadingModel> models,
            Section section, String help) {
        return new MaterialAttribute<>(name, NumericKind.number(0, max, step), initial, unit, get, with, term, models, section, help);
    }

    /** Returns itself if its values are images. */
    // The only kind of images has one type of values.
    @SuppressWarnings("unchecked")
    public Optional<MaterialAttribute<Optional<TextureMap>>> asMap() {
        return kind instanceof ValueKind.TextureKind ? Optional.of((MaterialAttribute<Optional<TextureMap>>) this) : Optional.empty();
    }

    /** Returns the meaning of the samples of its image; empty if its values are no images. */
    public Optional<TextureUsage> usage() {
        return kind instanceof ValueKind.TextureKind map ? Optional.of(map.usage()) : Optional.empty();
    }

    /** Returns whether it acts on materials of this model; otherwise it has its initial value there. */
    public boolean appliesTo(ShadingModel materialModel) {
        return models.contains(materialModel);
    }

    /** Returns a clause that says why materials of this model do not have it; empty if they do. */
    public Optional<String> inactiveReason(ShadingModel materialModel) {
        return appliesTo(materialModel) ? Optional.empty()
                : Optional.of(Messages.tr("a material of model {0} has no {1}", MODEL.kind().format(materialModel), Messages.tr(title())));
    }

    /**
     * Returns the value for a material of this model.
     *
     * @throws IllegalArgumentException if no material may have the value; the message says why
     */
    V checkFor(ShadingModel materialModel, V value) {
        check(value);
        return appliesTo(materialModel) ? value : initial();
    }

    /** Returns an attribute of a component that principled materials have. */
    private static <P, V> MaterialAttribute<V> part(AttributePart<Material, P> part, String name, String title,
            ValueKind.MaterialKind<V> kind, String unit, Function<P, V> get, BiFunction<P, V, P> with, MaterialTerm term, Section section,
            String help) {
        return new MaterialAttribute<>(name, title, kind, get.apply(part.initial()), unit, part.getter(get), part.setter(with), term,
                PRINCIPLED, section, help);
    }

    private static <V> MaterialAttribute<V> bumpAttribute(String name, String title, ValueKind.MaterialKind<V> kind, V initial, String unit,
            Function<BumpMapping, V> get, BiFunction<BumpMapping, V, BumpMapping> with, String help) {
        return new MaterialAttribute<>(name, title, kind, initial, unit, m -> get.apply(m.bumpMapping()),
                (m, v) -> m.withBumpMapping(with.apply(m.bumpMapping(), v)), MaterialTerm.NORMAL, ANY, Section.RELIEF, help);
    }

    private static <V> MaterialAttribute<V> cutoutAttribute(String name, ValueKind.MaterialKind<V> kind, V initial, String unit,
            Function<AlphaCutout, V> get,
            BiFunction<AlphaCutout, V, AlphaCutout> with, String help) {
        return new MaterialAttribute<>(name, kind, initial, unit, m -> get.apply(m.cutout()),
                (m, v) -> m.withCutout(with.apply(m.cutout(), v)), MaterialTerm.COVERAGE, ANY, Section.CUTOUT, help);
    }

    private static <V> MaterialAttribute<V> transmissionAttribute(String name, String title, ValueKind.MaterialKind<V> kind, V initial,
            String unit,
            Function<Transmission, V> get, BiFunction<Transmission, V, Transmission> with, MaterialTerm term, String help) {
        return new MaterialAttribute<>(name, title, kind, initial, unit, m -> get.apply(m.transmission()),
                (m, v) -> m.withTransmission(with.apply(m.transmission(), v)), term, ANY, Section.CLEAR, help);
    }

    /** Colors are equivalent if equal as floats, the precision of shading, channels if there is no image, and rotations of no anisotropy. */
    @Override
    public boolean isEquivalent(Material a, Material b) {
        return super.isEquivalent(a, b) || isPartOfNothing(a) && isPartOfNothing(b)
                || get(a) instanceof Rgb before && get(b) instanceof Rgb after && equalsAsFloat(before, after);
    }

    /** Returns whether it belongs to a map or an effect that a material lacks, so that its value changes nothing. */
    public boolean isPartOfNothing(Material m) {
        return this == ANISOTROPY_ROTATION && m.anisotropy().strength() == 0
                || this == ROUGHNESS_CHANNEL && m.surfaceMaps().roughness().isEmpty()
                || this == METALNESS_CHANNEL && m.surfaceMaps().metalness().isEmpty()
                || this == F0_CHANNEL && m.surfaceMaps().f0().isEmpty()
                || this == COAT_CHANNEL && m.layerMaps().coat().isEmpty()
                || this == COAT_ROUGHNESS_CHANNEL && m.layerMaps().coatRoughness().isEmpty()
                || this == SHEEN_ROUGHNESS_CHANNEL && m.layerMaps().sheenRoughness().isEmpty();
    }

    private static boolean equalsAsFloat(Rgb a, Rgb b) {
        return (float) a.r() == (float) b.r() && (float) a.g() == (float) b.g() && (float) a.b() == (float) b.b();
    }

    @Override
    public ValueKind.MaterialKind<V> kind() {
        return kind;
    }

    /** Returns the term that it changes. */
    public MaterialTerm term() {
        return term;
    }

    public Section section() {
        return section;
    }

    /** Returns its help text, a sentence without a full stop. */
    public String help() {
        return help;
    }
}
