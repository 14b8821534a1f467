package lightning.shot.cluster;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.file.ContentHash;
import lightning.format.jen.CachingJenReader;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.asset.JenLimits;
import lightning.scene.shot.Shot;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.wire.SceneManifest;
import lightning.shot.cluster.wire.WireException;
import org.jspecify.annotations.Nullable;

/** Reader of revisions from manifests. Keeps the newest revision and its files, as long as the next one uses the same files. */
final class RevisionReader {
    private final ContentFolder contents;
    private final ContentFolder.PartSource parts;
    private @Nullable ContentHash manifestHash;
    private @Nullable ShotRevision revision;
    private @Nullable Path folder;
    private @Nullable CachingJenReader reader;

    RevisionReader(ContentFolder contents, ContentFolder.PartSource parts) {
        this.contents = contents;
        this.parts = parts;
    }

    /**
     * Reads the revision of a manifest.
     *
     * @throws InvalidContentException if its content does not arrive or does not match the manifest
     * @throws IOException      if its content cannot be stored
     * @throws WireException    if the manifest is malformed
     * @throws JenException     if its text is not a valid scene, or a file that it names cannot be used
     */
    synchronized ShotRevision read(ContentHash hash, int bytes) throws IOException, WireException, JenException {
        if (revision != null && hash.equals(manifestHash)) {
            return revision;
        }
        SceneManifest manifest = SceneManifest.decode(readManifest(hash, bytes));
        Path sceneFolder = contents.sceneFolder(manifest, parts);
        if (reader == null || !sceneFolder.equals(folder)) {
            reader = new CachingJenReader(sceneFolder);
            folder = sceneFolder;
        }
        String text = Files.readString(contents.fetch(manifest.text(), JenLimits.FILE_BYTES, parts));
        JenDocument document = reader.read(text, "the scene");
        revision = new ShotRevision(document.scene(), document.shot().orElse(Shot.DEFAULT));
        manifestHash = hash;
        return revision;
    }

    private byte[] readManifest(ContentHash hash, int bytes) throws IOException {
        var manifest = new ByteArrayOutputStream();
        byte[] part = parts.read(hash, 0);
        while (part.length > 0 && manifest.size() + part.length <= Math.min(bytes, SceneManifest.MAX_BYTES)) {
            manifest.writeBytes(part);
            part = manifest.size() < bytes ? parts.read(hash, manifest.size()) : new byte[0];
        }
        if (part.length > 0 || manifest.size() != bytes || !ContentHash.of(manifest.toByteArray()).equals(hash)) {
            throw new InvalidContentException("expected a manifest of " + bytes + " bytes with its hash, found "
                    + (manifest.size() + part.length) + " bytes");
        }
        return manifest.toByteArray();
    }
}
