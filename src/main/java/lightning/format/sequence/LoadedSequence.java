package lightning.format.sequence;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.file.ParentFolder;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.light.LightRig;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;

/**
 * A sequence with its scenes in memory.
 *
 * @param file     file of the sequence
 * @param sequence its content
 * @param shots    its shots, in the same order
 * @param rig      the scene of the rig's file
 */
public record LoadedSequence(Path file, Sequence sequence, List<LoadedShot> shots, Scene rig) {
    /**
     * Shot with its scene as it is in its file.
     *
     * @param frames the shot that is rendered: that of the scene, limited to the frames of the sequence; one frame for a still scene
     */
    public record LoadedShot(String name, Path file, JenDocument document, Shot frames) {}

    /**
     * Reads a sequence and its scenes. A scene of several shots is read once.
     *
     * @throws IOException  if a file cannot be read, or a shot lacks frames; the message is a sentence for the user
     * @throws JenException if a scene has problems
     */
    public static LoadedSequence read(Path file) throws IOException, JenException {
        Sequence sequence = SequenceReader.read(file);
        Path folder = ParentFolder.of(file);
        Map<Path, JenDocument> documents = new LinkedHashMap<>();
        List<LoadedShot> shots = new ArrayList<>();
        for (Sequence.Entry entry : sequence.shots()) {
            Path path = folder.resolve(entry.scene());
            JenDocument document = documents.get(path);
            if (document == null) {
                document = JenReader.read(path);
                documents.put(path, document);
            }
            shots.add(new LoadedShot(entry.name(), path, document, frames(file, entry, document)));
        }
        Scene rig = rig(folder.resolve(sequence.rig()), documents);
        return new LoadedSequence(file, sequence, List.copyOf(shots), rig);
    }

    /** Lights may be linked to objects of the shots: the first scene in which all links exist counts. */
    private static Scene rig(Path file, Map<Path, JenDocument> documents) throws IOException, JenException {
        JenDocument known = documents.get(file);
        if (known != null) {
            return known.scene();
        }
        try {
            return JenReader.readLights(file, ParentFolder.of(file), Stage.EMPTY);
        } catch (JenException e) {
            for (JenDocument document : documents.values()) {
                try {
                    return JenReader.readLights(file, ParentFolder.of(file), document.scene().stage());
                } catch (JenException other) {
                    // Links to objects of another scene: the first message counts if none has them.
                }
            }
            throw e;
        }
    }

    private static Shot frames(Path file, Sequence.Entry entry, JenDocument document) throws IOException {
        Shot own = document.shot().orElse(Shot.DEFAULT);
        if (entry.frames().isEmpty()) {
            return own;
        }
        Sequence.Span span = entry.frames().get();
        if (span.first() < own.first() || span.last() > own.last()) {
            throw new IOException(Quote.path(file) + ": shot " + Quote.of(entry.name()) + ": expected frames from " + own.first() + " to "
                    + own.last() + ", which " + Quote.path(Path.of(entry.scene())) + " has, found " + span.first() + " to " + span.last());
        }
        return new Shot(span.first(), span.last(), own.rate(), own.tracks());
    }

    /** Returns this sequence with other overrides or notes of the same shots. */
    public LoadedSequence withSequence(Sequence v) {
        return new LoadedSequence(file, v, shots, rig);
    }

    /**
     * Returns a shot with the lights of the sequence and its own overrides. Links to shapes that it does not have are dropped, as are keyframes of
     * lights that the rig does not have.
     *
     * @param lights lights and, if the sequence shares it, the world for all shots
     * @throws RefusalException if a light has the name of a shape, or an override does not fit; the message names shot and override
     */
    public AnimatedScene lit(LoadedShot shot, Scene lights) {
        Scene own = shot.document().scene();
        LightRig rig = lights.rig().forShapes(own.stage()::hasNode);
        Scene lit;
        try {
            lit = (sequence.sharesWorld() ? own.withWorld(lights.world()) : own).withRig(rig);
        } catch (RefusalException e) {
            throw new RefusalException("shot " + Quote.of(shot.name()) + ": " + e.getMessage(), e);
        }
        for (String edit : sequence.shot(shot.name()).orElseThrow().overrides()) {
            try {
                lit = PropertyEdit.apply(lit, edit, ParentFolder.of(shot.file()));
            } catch (RefusalException e) {
                throw new RefusalException(
                        "shot " + Quote.of(shot.name()) + ": override " + Quote.of(edit) + ": " + e.getMessage(), e);
            }
        }
        return new AnimatedScene(own, Optional.of(shot.frames())).withScene(lit);
    }
}
