package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.document.loop.SamplePictures;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import lightning.scene.node.Shape;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Library of materials: its content, and edits that use it. */
class MaterialLibraryTest {
    private final Scene desk = DeskScene.scene();
    private final Material gold = MaterialLibrary.find("gold").orElseThrow();

    static Stream<Material> materials() {
        return MaterialLibrary.materials().stream();
    }

    private static String materialOf(Scene scene, String shape) {
        return ((Shape) scene.stage().node(shape).orElseThrow()).material();
    }

    @Test
    void library_hasTwoDozenMaterialsWithOwnNames() {
        assertThat(MaterialLibrary.materials()).hasSizeGreaterThanOrEqualTo(24).extracting(Material::name).doesNotHaveDuplicates();
    }

    @ParameterizedTest
    @MethodSource("materials")
    void material_isPrincipledAndHasNoImage(Material material) {
        assertThat(material.model()).isEqualTo(ShadingModel.PRINCIPLED);
        assertThat(MaterialAttribute.MAPS).allMatch(map -> map.get(material).isEmpty());
    }

    @Slow
    @ParameterizedTest
    @MethodSource("materials")
    void sampleOfMaterial_rendersFinite(Material material) {
        Scene sample = SamplePictures.inStudio(MaterialLibrary.sample(material));
        Scene scene = sample.withPicture(sample.picture().withSize(24, 24));
        try (var workers = new WorkerPool(1)) {
            Film film = new TraditionalTracer(scene).trace(workers, Progress.NONE).film();
            for (int y = 0; y < film.height(); y++) {
                for (int x = 0; x < film.width(); x++) {
                    assertThat(film.red(x, y) + film.green(x, y) + film.blue(x, y)).isFinite();
                }
            }
        }
    }

    @Test
    void appliedMaterial_isThatOfTheObject() {
        Scene after = DeskScene.sceneOf(MaterialLibrary.apply(desk, "ball", gold));
        assertThat(materialOf(after, "ball")).isEqualTo("gold");
        assertThat(after.materialsByName()).containsEntry("gold", gold);
    }

    @Test
    void materialAppliedTwice_isInTheSceneOnce() {
        Scene once = DeskScene.sceneOf(MaterialLibrary.apply(desk, "ball", gold));
        Scene twice = DeskScene.sceneOf(MaterialLibrary.apply(once, "ground", gold));
        assertThat(twice.materials()).isEqualTo(once.materials());
    }

    @Test
    void materialOfATakenName_getsANumber() {
        Scene before = DeskScene.sceneOf(MaterialLibrary.apply(desk, "ball", gold.withBase(Rgb.WHITE)));
        Scene after = DeskScene.sceneOf(MaterialLibrary.apply(before, "ground", gold));
        assertThat(materialOf(after, "ground")).isEqualTo("gold 2");
        assertThat(materialOf(after, "ball")).isEqualTo("gold");
        assertThat(after.materialsByName().get("gold").base()).isEqualTo(Rgb.WHITE);
    }

    @Test
    void replacedMaterial_isThatOfAllItsObjects() {
        String before = materialOf(desk, "ball");
        Scene after = DeskScene.sceneOf(MaterialLibrary.replace(desk, before, gold));
        List<Shape> users = desk.stage().shapes().stream().filter(s -> s.material().equals(before)).toList();
        assertThat(users).isNotEmpty().allMatch(s -> materialOf(after, s.name()).equals("gold"));
        assertThat(after.stage().shapes()).filteredOn(s -> s.material().equals("gold")).hasSameSizeAs(users);
    }

    @Test
    void missingObject_isRefused() {
        assertThat(MaterialLibrary.apply(desk, "nothing", gold).refusal()).hasValueSatisfying(r -> assertThat(r).contains("nothing"));
    }
}
