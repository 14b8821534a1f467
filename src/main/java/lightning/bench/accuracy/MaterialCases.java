package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.scene.Clarity;
import lightning.scene.Cutout;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.Relief;
import lightning.scene.Scene;

/**
 * Edits of materials, which the paper leaves as future work (§5.2). Each edits the first material on a shape that has
 * what it needs (switches, of another value, the next), and is left out where none has.
 */
final class MaterialCases {
    private static final Predicate<Material> ANY = m -> true;
    private static final Predicate<Material> TEXTURED = m -> m.texture().isPresent();

    private final List<PaperCase> cases = new ArrayList<>();
    private final Scene scene;
    private final List<Material> used;

    /** Which of the {@link PaperCases#VALUES} values edits take. */
    private final int value;

    private MaterialCases(Scene scene, int value) {
        this.scene = scene;
        this.value = value;
        used = scene.placedShapes().stream().map(shape -> shape.material()).distinct().toList();
    }

    /** @param value 0 to {@link PaperCases#VALUES} − 1 */
    static List<PaperCase> of(Scene scene, int value) {
        var builder = new MaterialCases(scene, value);
        double share = new double[] {0.5, 0.8, 0.25}[value];
        Predicate<Material> mirrors = m -> scene.picture().depth() > 0 && m.isMirror();
        builder.edit("material-color", ANY, m -> m.withBody(m.body().times(share)));
        builder.edit("shininess", m -> !m.specular().isBlack(),
                m -> m.withShininess(Math.min(m.shininess() / share + 1, Limits.MAX_SHININESS)));
        builder.edit("reflectivity", mirrors, m -> m.withReflective(m.reflective().times(share)));
        builder.offAndOn("mirror", mirrors, m -> m.withReflective(Rgb.BLACK));
        builder.offAndOn("texture", TEXTURED, m -> m.withTexture(Optional.empty()));
        builder.edit("roughness", Material::isMetallic, m -> m.withRoughness(m.roughness() * share));
        builder.edit("tint", m -> m.clarity().isTinted(), m -> m.withClarity(m.clarity().withTint(m.clarity().tint().times(share))));
        builder.offAndOn("clear", m -> m.clarity().isClear(), m -> m.withClarity(Clarity.NONE));
        builder.offAndOn("relief", m -> !m.relief().isFlat(), m -> m.withRelief(Relief.NONE));
        builder.offAndOn("cutout", m -> m.cutout().cuts(), m -> m.withCutout(Cutout.NONE));
        return builder.cases;
    }

    private void edit(String name, Predicate<Material> needed, UnaryOperator<Material> edit) {
        used.stream().filter(needed).findFirst().ifPresent(m -> add(name, scene.withMaterial(edit.apply(m))));
    }

    /** Something taken from a material, and given back; another value is another material. */
    private void offAndOn(String what, Predicate<Material> has, UnaryOperator<Material> off) {
        used.stream().filter(has).skip(value).findFirst().map(m -> scene.withMaterial(off.apply(m))).ifPresent(without -> {
            add(what + "-off", without);
            add(what + "-on", without, scene);
        });
    }

    private void add(String name, Scene... steps) {
        cases.add(PaperCase.further(name, scene, steps));
    }
}
