package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.format.exchange.ImportLighting;
import lightning.format.exchange.ImportOptions;
import lightning.format.exchange.SceneImporter;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Material;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which pictures of earlier processes are found, and that they are those of the scene. */
class KeptPicturesTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final long MANY_BYTES = 1 << 28;

    @TempDir
    private Path folder;
    private final Renderer renderer = new Renderer(OPTIONS);

    @AfterEach
    void close() {
        renderer.close();
    }

    private KeptPictures pictures(long maxBytes, String program) {
        return KeptPictures.in(folder.resolve("pictures"), maxBytes, Optional.of(program));
    }

    private PixelCache trace(Scene scene) {
        renderer.clear();
        renderer.render(scene, Progress.NONE);
        return renderer.cache();
    }

    private Optional<PixelCache> find(Scene scene, String program) {
        renderer.clear();
        return pictures(MANY_BYTES, program).find(scene, renderer::prepare, MANY_BYTES);
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("pictures"))) {
            return files.sorted().toList();
        }
    }

    @Test
    void equalSceneOfAnotherProcess_hasItsPicture() throws IOException {
        PixelCache traced = trace(DeskScene.scene());
        pictures(MANY_BYTES, "program").keep(traced);
        assertThat(find(DeskScene.scene(), "program")).hasValueSatisfying(found -> {
            assertThat(found.film().hasSameBits(traced.film())).isTrue();
            renderer.restore(found);
            assertThat(renderer.render(DeskScene.scene(), Progress.NONE).rays().total()).isZero();
        });
    }

    @Test
    void otherValueOrProgram_isNotFound() throws IOException {
        pictures(MANY_BYTES, "program").keep(trace(DeskScene.scene()));
        assertThat(find(DeskScene.scene(), "newer program")).isEmpty();
        assertThat(find(PropertyEdit.apply(DeskScene.scene(), "key.intensity=1.1"), "program")).isEmpty();
    }

    private static Scene textured() throws Exception {
        return textured(Path.of("scenes"));
    }

    private static Scene textured(Path from) throws Exception {
        String text = """
                jen 1
                picture { size 30 20 }
                material board { diffuse 1 1 1  texture "wood.png" }
                plane ground { material board  at 0 -1 0  scale 9 1 9 }
                light key point { at 0 3 3 }
                """;
        return JenReader.read(text, "desk.jen", from).scene();
    }

    /** A scene may be read with smaller images than those it was opened with, if other images are there or gone. */
    @Test
    void imageOfOtherSize_isNotFound() throws Exception {
        Scene scene = textured();
        pictures(MANY_BYTES, "program").keep(trace(scene));
        Material board = scene.materials().getFirst();
        TextureMap map = board.texture().orElseThrow();
        Scene smaller = scene.withMaterials(List.of(board.withTexture(Optional.of(map.withImage(new Texture(2, 1, new float[6]))))));
        assertThat(JenDocument.of(smaller).text()).isEqualTo(JenDocument.of(scene).text());
        assertThat(find(smaller, "program")).isEmpty();
    }

    private static Path folderWith(Path folder, String texture) throws IOException {
        Files.createDirectories(folder);
        Files.copy(Path.of("textures", texture), folder.resolve("wood.png"), StandardCopyOption.REPLACE_EXISTING);
        return folder;
    }

    @Test
    void textureOfOtherContent_isNotFound() throws Exception {
        pictures(MANY_BYTES, "program").keep(trace(textured()));
        assertThat(files()).hasSize(1);
        assertThat(find(textured(), "program")).isPresent();
        assertThat(find(textured(folderWith(folder.resolve("other"), "checker.png")), "program")).isEmpty();
    }

    @Test
    void meshOfOtherContent_isNotFound() throws Exception {
        String text = """
                jen 1
                picture { size 30 20 }
                material clay { diffuse 1 1 1 }
                mesh part { file "part.obj" material clay }
                light key point { at 0 3 3 }
                """;
        Path file = folder.resolve("part.obj");
        Files.writeString(file, "v -1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        pictures(MANY_BYTES, "program").keep(trace(JenReader.read(text, "part.jen", folder).scene()));
        assertThat(find(JenReader.read(text, "part.jen", folder).scene(), "program")).isPresent();
        Files.writeString(file, "v -1 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
        assertThat(find(JenReader.read(text, "part.jen", folder).scene(), "program")).isEmpty();
    }

    /** An import writes files, which are read and shown by the same process. */
    @Test
    void fileWrittenByThisProcess_keepsPicture() throws Exception {
        pictures(MANY_BYTES, "program").keep(trace(textured(folderWith(folder.resolve("mine"), "wood.png"))));
        assertThat(find(textured(folder.resolve("mine")), "program")).isPresent();
    }

    @Test
    void fileThatChangedAfterItWasRead_isNotShown() throws Exception {
        Path mine = folderWith(folder.resolve("mine"), "wood.png");
        Scene read = textured(mine);
        folderWith(mine, "checker.png");
        pictures(MANY_BYTES, "program").keep(trace(read));
        assertThat(find(textured(mine), "program")).isEmpty();
        assertThat(find(textured(folderWith(mine, "wood.png")), "program")).as("the file that was read").isPresent();
    }

    /** Saving in another folder copies files or finds them there; the scene that was traced still has the first folder. */
    @Test
    void sceneWithItsFilesInAnotherFolder_isFound() throws Exception {
        pictures(MANY_BYTES, "program").keep(trace(textured()));
        assertThat(find(textured(folderWith(folder.resolve("copy"), "wood.png")), "program")).isPresent();
    }

    @Test
    void importedMeshInStudio_isFound() throws Exception {
        Path model = Files.writeString(folder.resolve("part.obj"), """
                mtllib part.mtl
                usemtl clay
                v -1 0 -1
                v 1 0 -1
                v 1 0 1
                v -1 2 1
                f 1 2 3
                f 1 3 4
                """);
        Files.writeString(folder.resolve("part.mtl"), "newmtl clay\nKd 0.6 0.3 0.2\nmap_Kd wood.png\n");
        folderWith(folder, "wood.png");
        ImportedScene imported = ImportLighting.STUDIO.apply(
                SceneImporter.read(model, folder.resolve("part.jen"), ImportOptions.DEFAULT, Progress.NONE));
        imported.withPicture(imported.scene().picture().withSize(24, 16)).write();
        Scene opened = JenReader.read(folder.resolve("part.jen")).scene();
        pictures(MANY_BYTES, "program").keep(trace(opened));
        assertThat(find(JenReader.read(folder.resolve("part.jen")).scene(), "program")).isPresent();
    }

    /** An assignment appends the material to those in use; a first pass has them in the order of objects. */
    @Test
    void sceneSavedAfterOtherMaterialWasAssigned_isFoundAndContinues() throws Exception {
        String text = """
                jen 1
                picture { size 30 20  indirect { rays 16 } }
                material clay { diffuse 1 1 1 }
                material gold { diffuse 1 0.8 0.2  reflective 0.3 0.3 0.3 }
                material steel { model principled  base 0.8 0.8 0.8  metalness 1  roughness 0.3 }
                sphere ball { material clay  at 0 1 0 }
                plane ground { material steel  scale 9 1 9 }
                sphere other { material clay  at 2 1 0 }
                light key point { at 0 3 3 }
                """;
        Scene first = JenReader.read(text, "a.jen", folder).scene();
        String assigned = text.replace("ball { material clay", "ball { material gold");
        Scene edited = JenReader.read(assigned, "a.jen", folder).scene();
        renderer.render(first, Progress.NONE);
        renderer.render(edited, Progress.NONE);
        pictures(MANY_BYTES, "program").keep(renderer.cache());
        PixelCache found = find(JenReader.read(assigned, "a.jen", folder).scene(), "program").orElseThrow();
        Scene next = JenReader.read(assigned.replace("at 2 1 0", "at 2 1 0.5").replace("ground { material steel", "ground { material clay"),
                "a.jen", folder).scene();
        renderer.restore(found);
        renderer.render(next, Progress.NONE);
        assertThat(renderer.film().hasSameBits(new ReferenceTracer(next).trace())).isTrue();
    }

    private void closeWith(Consumer<RenderLoop> closing) throws Exception {
        var listener = new RecordingRenderListener();
        try (var loop = new RenderLoop(OPTIONS, listener, pictures(MANY_BYTES, "program"))) {
            loop.render(DeskScene.scene());
            listener.expectNext(RecordingRenderListener.Event.IDLE);
            loop.render(edited());
            listener.expectNext(RecordingRenderListener.Event.IDLE);
            closing.accept(loop);
        }
    }

    private static Scene edited() {
        return PropertyEdit.apply(DeskScene.scene(), "key.intensity=2");
    }

    @Test
    void sceneSavedJustBeforeClosing_isFound() throws Exception {
        closeWith(RenderLoop::keepPicture);
        assertThat(find(edited(), "program")).isPresent();
    }

    @Test
    void sceneSavedJustBeforeOpeningAnother_isFound() throws Exception {
        closeWith(loop -> {
            loop.keepPicture();
            loop.open(DeskScene.scene().withPicture(DeskScene.scene().picture().withSize(5, 5)), 1);
            loop.open(DeskScene.scene(), 2);
        });
        assertThat(find(edited(), "program")).isPresent();
    }

    @Test
    void picturesOfTooManyBytes_replaceThoseUsedFirst() throws IOException {
        PixelCache first = trace(DeskScene.scene());
        pictures(MANY_BYTES, "program").keep(first);
        long bytes = Files.size(files().getFirst());
        Path oldest = files().getFirst();
        Files.setLastModifiedTime(oldest, FileTime.from(Instant.now().minusSeconds(60)));
        long space = 2 * bytes + bytes / 2;
        pictures(space, "program").keep(trace(PropertyEdit.apply(DeskScene.scene(), "key.intensity=2")));
        assertThat(files()).hasSize(2);
        pictures(space, "program").keep(trace(PropertyEdit.apply(DeskScene.scene(), "key.intensity=3")));
        assertThat(files()).hasSize(2).doesNotContain(oldest);
    }

    @Test
    void damagedPicture_isRemovedAndNotShown() throws IOException {
        pictures(MANY_BYTES, "program").keep(trace(DeskScene.scene()));
        byte[] bytes = Files.readAllBytes(files().getFirst());
        bytes[bytes.length / 2] ^= 1;
        Files.write(files().getFirst(), bytes);
        assertThat(find(DeskScene.scene(), "program")).isEmpty();
        assertThat(files()).isEmpty();
    }

    @Test
    void switchedOff_deletesAll() throws IOException {
        KeptPictures kept = pictures(MANY_BYTES, "program");
        PixelCache traced = trace(DeskScene.scene());
        kept.keep(traced);
        kept.setEnabled(false);
        assertThat(files()).isEmpty();
        kept.keep(traced);
        assertThat(files()).isEmpty();
        kept.setEnabled(true);
        kept.keep(traced);
        assertThat(files()).hasSize(1);
    }

    @Test
    void onlyTheOwner_canReadThem() throws IOException {
        pictures(MANY_BYTES, "program").keep(trace(DeskScene.scene()));
        if (Files.getFileStore(folder).supportsFileAttributeView("posix")) {
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve("pictures")))).isEqualTo("rwx------");
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(files().getFirst()))).isEqualTo("rw-------");
        }
    }

    @Test
    void sceneOpenedAgain_isNotTraced() {
        Scene scene = DeskScene.scene();
        try (var keeper = new PictureKeeper(pictures(MANY_BYTES, "program"))) {
            keeper.restore(scene, renderer, () -> {});
            assertThat(renderer.state().hasPicture()).isFalse();
            renderer.render(scene, Progress.NONE);
            assertThat(keeper.isNew()).isTrue();
            keeper.keep(renderer);
        }
        renderer.clear();
        try (var keeper = new PictureKeeper(pictures(MANY_BYTES, "program"))) {
            keeper.restore(scene, renderer, () -> {});
            UpdateResult nothing = renderer.render(scene, Progress.NONE);
            assertThat(nothing.rays().total()).isZero();
            assertThat(keeper.isNew()).as("already kept").isFalse();
        }
    }
}
