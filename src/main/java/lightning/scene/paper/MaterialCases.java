package lightning.scene.paper;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.scene.Scene;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import lightning.scene.value.SceneLimits;

/**
 * Edits of materials, which the paper leaves as future work (§5.2). Each edits the first suitable material on a shape (other values: the
 * next one). Cases without a suitable material are skipped.
 */
public final class MaterialCases {
    private static final Predicate<Material> ANY = m -> true;
    private static final Predicate<Material> TEXTURED = m -> m.texture().isPresent();

    private final List<PaperCase> cases = new ArrayList<>();
    private final Scene scene;
    private final List<Material> usedMaterials;

    /** Index of the value, below {@link PaperCases#VALUES}. */
    private final int value;

    private MaterialCases(Scene scene, int value) {
        this.scene = scene;
        this.value = value;
        usedMaterials = scene.placedShapes().stream().map(shape -> shape.material()).distinct().toList();
    }

    /** @param value 0 to {@link PaperCases#VALUES} − 1 */
    public static List<PaperCase> of(Scene scene, int value) {
        var builder = new MaterialCases(scene, value);
        double share = new double[] {0.5, 0.8, 0.25}[value];
        Predicate<Material> mirrors = m -> scene.picture().depth() > 0 && m.isMirror();
        builder.addEdit("material-color", ANY, m -> m.withAlbedo(m.albedo().times(share)));
        builder.addEdit("shininess", m -> !m.specular().isBlack(),
                m -> m.withShininess(Math.min(m.shininess() / share + 1, SceneLimits.MAX_SHININESS)));
        builder.addEdit("reflectivity", mirrors, m -> m.withReflective(m.reflective().times(share)));
        builder.addOffAndOn("mirror", mirrors, m -> m.withReflective(Rgb.BLACK));
        builder.addOffAndOn("texture", TEXTURED, m -> m.withTexture(Optional.empty()));
        builder.addEdit("roughness", Material::isMetallic, m -> m.withRoughness(m.roughness() * share));
        builder.addEdit("tint", m -> m.transmission().isTinted(),
                m -> m.withTransmission(m.transmission().withTint(m.transmission().tint().times(share))));
        builder.addOffAndOn("clear", m -> m.transmission().isTransparent(), m -> m.withTransmission(Transmission.NONE));
        builder.addOffAndOn("relief", m -> !m.bumpMapping().isFlat(), m -> m.withBumpMapping(BumpMapping.NONE));
        builder.addOffAndOn("cutout", m -> m.cutout().isActive(), m -> m.withCutout(AlphaCutout.NONE));
        return builder.cases;
    }

    private void addEdit(String name, Predicate<Material> condition, UnaryOperator<Material> edit) {
        usedMaterials.stream().filter(condition).findFirst().ifPresent(m -> add(name, scene.withMaterial(edit.apply(m))));
    }

    /** Adds cases that remove and restore a property of a material; other values edit other materials. */
    private void addOffAndOn(String name, Predicate<Material> condition, UnaryOperator<Material> off) {
        usedMaterials.stream().filter(condition).skip(value).findFirst().map(m -> scene.withMaterial(off.apply(m))).ifPresent(changed -> {
            add(name + "-off", changed);
            add(name + "-on", changed, scene);
        });
    }

    private void add(String name, Scene... steps) {
        cases.add(PaperCase.unprinted(name, scene, steps));
    }
}
