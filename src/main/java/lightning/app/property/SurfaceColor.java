package lightning.app.property;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import lightning.app.model.EditorModel;
import lightning.app.widget.ColorSliders;
import lightning.app.widget.Gauge;
import lightning.edit.Change;
import lightning.edit.Hsv;
import lightning.edit.MaterialEdits;
import lightning.edit.Steps;
import lightning.math.Rgb;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Scene;

/** The colours of a material. */
enum SurfaceColor {
    DIFFUSE("The light that the surface scatters; times the texture where there is one", 1, Material::diffuse, MaterialEdits::diffuse),
    SPECULAR("The colour of highlights; black for none", 1, Material::specular, MaterialEdits::specular),
    REFLECTIVE("How much the surface mirrors; black for no mirror", 1, Material::reflective, MaterialEdits::reflective),
    AMBIENT("What the surface shows without a light: times the scene's ambience, 0 or more", Limits.MAX_EMISSION, Material::ambient,
            MaterialEdits::ambient);

    private final String help;
    private final double max;
    private final Function<Material, Rgb> of;
    private final Edit edit;

    private interface Edit {
        Change of(Scene scene, String material, Rgb color);
    }

    SurfaceColor(String help, double max, Function<Material, Rgb> of, Edit edit) {
        this.help = help;
        this.max = max;
        this.of = of;
        this.edit = edit;
    }

    /** In the words of the file: {@code diffuse}. */
    String title() {
        return name().toLowerCase(Locale.ROOT);
    }

    Rgb of(Material material) {
        return of.apply(material);
    }

    /** The sliders of the edited material's colour; whoever made them shows it. */
    ColorSliders sliders(EditorModel model) {
        var sliders = ColorSliders.ofSurface(title(), help, max, new Target(model));
        sliders.setId(title());
        return sliders;
    }

    private final class Target implements ColorSliders.Target {
        private final EditorModel model;

        Target(EditorModel model) {
            this.model = model;
        }

        @Override
        public Gauge red() {
            return channel("red", v -> c -> new Rgb(v, c.g(), c.b()));
        }

        @Override
        public Gauge green() {
            return channel("green", v -> c -> new Rgb(c.r(), v, c.b()));
        }

        @Override
        public Gauge blue() {
            return channel("blue", v -> c -> new Rgb(c.r(), c.g(), v));
        }

        private Gauge channel(String name, Function<Double, UnaryOperator<Rgb>> with) {
            return Gauge.of(title() + " " + name, new Steps(0.1, 0, max), (v, gesture) -> edit(with.apply(v), gesture));
        }

        @Override
        public Optional<String> hsv(Hsv color, Object gesture) {
            return edit(_ -> color.rgb(), gesture);
        }

        private Optional<String> edit(UnaryOperator<Rgb> with, Object gesture) {
            Material material = model.materials().material();
            return model.edit(scene -> edit.of(scene, material.name(), with.apply(of(material))), gesture);
        }
    }
}
