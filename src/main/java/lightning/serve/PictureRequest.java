package lightning.serve;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.file.AtomicFile;
import lightning.base.file.SharedMemoryFile;
import lightning.base.work.Progress;
import lightning.format.exr.ExrType;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.InputFiles;
import lightning.layer.LayerPlanes;
import lightning.layer.LayeredExrWriter;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.SceneView;
import lightning.render.relight.UpdateResult;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Request {@code render}: updates the picture and writes it, a region of it, or one light's part of it. */
final class PictureRequest {
    private final SceneSession session;
    private final Request request;
    private final Scene scene;
    private final PictureRegion region;
    private final Optional<String> light;
    private final Optional<Path> file;
    private final int bits;
    private final boolean hasLayers;
    private final boolean hasMemory;
    private final Optional<Path> memoryPath;

    /** Reads and checks all fields before anything is rendered. */
    PictureRequest(SceneSession session, Request request) throws IOException {
        this.session = session;
        this.request = request;
        Fields fields = request.fields();
        scene = session.scene();
        fields.flag("progress");
        region = PictureRegion.of(fields, scene.picture());
        light = fields.optionalString("light");
        file = fields.optionalString("file").map(Path::of);
        hasLayers = fields.flag("layers");
        memoryPath = fields.memoryPath();
        hasMemory = fields.has("memory");
        light.filter(name -> scene.light(name).isEmpty()).ifPresent(name -> {
            throw Fields.bad("light", "the scene has no light '" + name + "'");
        });
        if (hasLayers && (light.isPresent() || fields.has("region"))) {
            throw Fields.bad("layers", "layers are those of the whole picture");
        }
        bits = file.isPresent() ? checkFile(fields, file.get()) : 0;
        if (file.isEmpty() && (hasLayers && !hasMemory || fields.has("bits"))) {
            throw Fields.bad("file", "missing; bits belong to a file, layers to a file or to memory");
        }
    }

    private int checkFile(Fields fields, Path picture) throws IOException {
        ImageFormat format = ImageFormat.of(picture);
        int depth = fields.integer("bits", 1, Integer.SIZE, format.bitDepths().getFirst());
        format.requireBitDepth(picture, depth);
        if (hasLayers && !format.canHaveLayers()) {
            throw Fields.bad("layers", "layers are written to .exr");
        }
        InputFiles.of(session.document().file(), List.of(scene)).check(picture);
        AtomicFile.of(picture).check();
        return depth;
    }

    ObjectNode run() throws IOException {
        PictureSettings picture = scene.picture();
        UpdateResult update =
                session.update(request, file.isEmpty() ? 0 : ImageFormat.of(file.get()).bytesToWrite(picture.width(), picture.height()));
        long start = System.nanoTime();
        ObjectNode result = JsonLines.JSON.createObjectNode();
        result.putArray("size").add(region.width()).add(region.height());
        result.put("plan", update.plan().description()).put("rays", update.rays().total()).put("milliseconds", update.milliseconds());
        Renderer renderer = session.renderer();
        Progress canceled = Progress.cancellation(request::isCanceled);
        Film film = light.isPresent() ? renderer.contribution(new SceneElement.OfLight(light.get()), canceled) : renderer.film();
        var rows = new FloatRows(film, region);
        if (hasMemory && hasLayers && file.isEmpty()) {
            writePlanes(renderer, canceled, result.putObject("memory"));
        } else if (hasMemory) {
            SharedMemoryFile memory = session.sharedPictures().file(request.client(), memoryPath, rows.bytes());
            // A picture that is half overwritten would be neither the old one nor the new one.
            rows.write(memory, session.server().writers());
            rows.describe(memory, result.putObject("memory"));
        }
        if (file.isPresent()) {
            if (hasLayers) {
                new LayeredExrWriter(renderer.cache(), renderer.options().engines(), bits == Short.SIZE ? ExrType.HALF : ExrType.FLOAT)
                        .write(file.get(), renderer.options().memory() - renderer.state().bytes(), session.server().writers(), canceled);
            } else {
                ImageFile.write(file.get(), rows.toFilm(), SceneView.of(scene), bits, session.server().writers());
            }
            result.put("file", file.get().toAbsolutePath().toString());
        }
        return result.put("writing_milliseconds", (System.nanoTime() - start) / 1e6);
    }

    private void writePlanes(Renderer renderer, Progress canceled, ObjectNode node) throws IOException {
        var planes = new LayerPlanes(renderer.cache(), renderer.options().engines());
        SharedMemoryFile memory = session.sharedPictures().layersFile(request.client(), memoryPath, planes.bytes());
        planes.write(memory, renderer.options().memory() - renderer.state().bytes(), session.server().writers(), canceled);
        node.put("path", memory.path().toString()).put("bytes", memory.bytes()).put("type", "float32").put("order", "little");
        node.putArray("shape").add(planes.channels().size()).add(scene.picture().height()).add(scene.picture().width());
        ArrayNode channels = node.putArray("channels");
        planes.channels().forEach(channels::add);
        planes.descriptions().forEach((name, json) -> node.set(name.substring(name.indexOf('/') + 1), JsonLines.JSON.readTree(json)));
    }
}
