package lightning.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.math.Rgb;

/** The attributes of materials, each described here and nowhere else, in the order in which a file writes them. */
public final class MaterialAttribute<V> extends Attribute<Material, V> {

    /** What people find together, in this order. */
    public enum Section {
        DIFFUSE,
        TEXTURE,
        SPECULAR,
        REFLECTIVE,
        AMBIENT
    }

    public static final MaterialAttribute<Rgb> AMBIENT = color("ambient", Limits.MAX_EMISSION, Rgb.BLACK, Material::ambient,
            Material::withAmbient, Section.AMBIENT, "What the surface shows without a light: times the scene's ambience, 0 or more");
    public static final MaterialAttribute<Rgb> DIFFUSE = color("diffuse", 1, Rgb.grey(0.8), Material::diffuse,
            Material::withDiffuse, Section.DIFFUSE, "The light that the surface scatters; times the texture where there is one");
    public static final MaterialAttribute<Optional<TextureMap>> TEXTURE = new MaterialAttribute<>("texture", new Kind.Texturing(),
            Optional.empty(), "", Material::texture, Material::withTexture, MaterialTerm.TEXEL, Section.TEXTURE,
            "The picture on the surface");
    public static final MaterialAttribute<Rgb> SPECULAR = color("specular", 1, Rgb.BLACK, Material::specular,
            Material::withSpecular, Section.SPECULAR, "The colour of highlights; black for none");
    public static final MaterialAttribute<Double> SHININESS = new MaterialAttribute<>("shininess",
            Quantity.number(0, Limits.MAX_SHININESS, 1), 16.0, "exponent", Material::shininess, Material::withShininess,
            MaterialTerm.HIGHLIGHT, Section.SPECULAR, "How small highlights are");
    public static final MaterialAttribute<Rgb> REFLECTIVE = color("reflective", 1, Rgb.BLACK, Material::reflective,
            Material::withReflective, Section.REFLECTIVE, "How much the surface mirrors; black for no mirror");

    /** All of them. */
    public static final List<MaterialAttribute<?>> ALL = List.of(AMBIENT, DIFFUSE, TEXTURE, SPECULAR, SHININESS, REFLECTIVE);

    private final MaterialTerm term;
    private final Section section;
    private final String help;

    private MaterialAttribute(String name, Kind<V> kind, V initial, String unit, Function<Material, V> get,
            BiFunction<Material, V, Material> with, MaterialTerm term, Section section, String help) {
        super(name, name, kind, initial, unit, get, with);
        this.term = term;
        this.section = section;
        this.help = help;
    }

    private static MaterialAttribute<Rgb> color(String name, double max, Rgb initial, Function<Material, Rgb> get,
            BiFunction<Material, Rgb, Material> with, Section section, String help) {
        return new MaterialAttribute<>(name, Quantity.color(max), initial, "linear red, green, blue", get, with, MaterialTerm.COLOR,
                section, help);
    }

    /** Colours are alike where they are as floats, which rows are coloured with. */
    @Override
    public boolean isAlike(Material a, Material b) {
        return super.isAlike(a, b) || of(a) instanceof Rgb before && of(b) instanceof Rgb after && sameFloats(before, after);
    }

    private static boolean sameFloats(Rgb a, Rgb b) {
        return (float) a.r() == (float) b.r() && (float) a.g() == (float) b.g() && (float) a.b() == (float) b.b();
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
