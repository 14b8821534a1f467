package lightning.serve;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.file.SharedMemoryFile;
import lightning.document.loop.CoarsePicture;
import tools.jackson.databind.node.ObjectNode;

/** Request {@code render} with {@code coarse}: traces a smaller picture in a short time. The cache stays as it is. */
final class CoarseRequest {
    private static final int MAX_MILLISECONDS = 1000;

    private final SceneSession session;
    private final Request request;
    private final double seconds;
    private final Optional<Path> memoryPath;

    /** Reads and checks all fields before anything is rendered. */
    CoarseRequest(SceneSession session, Request request) {
        this.session = session;
        this.request = request;
        Fields fields = request.fields();
        fields.flag("progress");
        seconds = fields.integer("coarse", 1, MAX_MILLISECONDS) / 1e3;
        for (String name : List.of("region", "light", "file", "bits", "layers")) {
            if (fields.has(name)) {
                throw Fields.bad(name, "a coarse picture is the whole picture, in memory");
            }
        }
        memoryPath = fields.memoryPath();
        if (!fields.has("memory")) {
            throw Fields.bad("memory", "missing; a coarse picture is written to memory");
        }
    }

    ObjectNode run() throws IOException {
        long start = System.nanoTime();
        CoarsePicture picture = session.traceCoarse(request, seconds);
        long traced = System.nanoTime();
        var region = new PictureRegion(0, 0, picture.film().width(), picture.film().height());
        var rows = new FloatRows(picture.film(), region);
        ObjectNode result = JsonLines.JSON.createObjectNode();
        result.putArray("size").add(region.width()).add(region.height());
        result.put("milliseconds", (traced - start) / 1e6);
        SharedMemoryFile memory = session.sharedPictures().coarseFile(request.client(), memoryPath, rows.bytes());
        rows.write(memory, session.server().writers());
        rows.describe(memory, result.putObject("memory"));
        return result.put("writing_milliseconds", (System.nanoTime() - traced) / 1e6);
    }
}
