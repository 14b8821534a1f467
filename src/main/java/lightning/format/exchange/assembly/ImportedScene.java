package lightning.format.exchange.assembly;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.file.AtomicFile;
import lightning.base.file.ParentFolder;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.CachingJenReader;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.JenWriter;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.ObjectLight;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/**
 * Scene converted from another program's file, not written yet.
 *
 * @param unscaledScene the scene; if the file does not define the units of its lights, their intensities are the raw
 *     numbers. Its textures are black placeholder pixels
 * @param unscaledShot animation of the scene, with tracks that it can have, in the same units; empty for none
 * @param restored names of lights whose intensities are not raw numbers
 * @param rawGlows names of materials whose glow is a raw number
 * @param units assumed units of the raw numbers; empty if the intensities are final
 * @param comments comment lines at the start of the scene file
 * @param sceneFile output file
 * @param copies files to copy next to it
 * @param notes omitted or approximated features with their counts
 * @param subject what the file contains
 * @param closingComments comment lines at the end of the scene file
 */
public record ImportedScene(Scene unscaledScene, Optional<Shot> unscaledShot, Set<String> restored, Set<String> rawGlows,
        Optional<LightUnits> units,
        List<String> comments, Path sceneFile,
        List<AssetCopy> copies,
        Map<String, Integer> notes, ImportSubject subject, List<String> closingComments) {
    /** Notes about what replaces missing parts of the file. */
    static final String ADDED_LIGHT = "no lights in the file; added one";
    static final String ADDED_CAMERA = "no cameras in the file; added one";
    /** Comment of a scene that got a light because the file has none. */
    static final String ADDED_LIGHT_COMMENT = "no light in the file; this one was added";
    /** Smooth edges of imported pictures. */
    public static final SamplingSettings SMOOTH = new SamplingSettings(AntialiasMode.EDGES, 4);
    private static final String FORMAT_LINE = "jen 1\n";

    /** Returns this scene with other light units, or this object if the file defines its units. */
    public ImportedScene inUnits(LightUnits newUnits) {
        return units.isEmpty() ? this
                : new ImportedScene(unscaledScene, unscaledShot, restored, rawGlows, Optional.of(newUnits), comments, sceneFile, copies,
                        notes,
                        subject,
                        closingComments);
    }

    /** Returns this scene with indirect light, of the default settings if the file has none. */
    public ImportedScene withIndirect() {
        return hasIndirect() ? this : withPicture(unscaledScene.picture().withIndirect(Optional.of(IndirectSettings.INITIAL)));
    }

    /** Returns this scene without indirect light. */
    public ImportedScene withoutIndirect() {
        return withPicture(unscaledScene.picture().withIndirect(Optional.empty()));
    }

    /** Returns this scene with other objects and materials; its lights keep their names. */
    public ImportedScene withObjects(UnaryOperator<Scene> change) {
        return new ImportedScene(change.apply(unscaledScene), unscaledShot, restored, rawGlows, units, comments, sceneFile, copies, notes,
                subject, closingComments);
    }

    /** Returns this scene with a light for every object that glows. */
    public ImportedScene withGlowingLights() {
        return new ImportedScene(ObjectLight.makeAll(scene()), shot(), Set.of(), Set.of(), Optional.empty(), comments, sceneFile, copies,
                notes, subject,
                closingComments);
    }

    /** Returns this scene with other settings of its image. */
    public ImportedScene withPicture(PictureSettings picture) {
        return new ImportedScene(unscaledScene.withPicture(picture), unscaledShot, restored, rawGlows, units, comments, sceneFile, copies,
                notes,
                subject,
                closingComments);
    }

    /**
     * Returns this scene with lights that replace those of the file.
     *
     * @param comment comment line that says so, if the file has lights
     * @param image        image of the lighting, to place next to the scene
     * @param furtherNotes what else was replaced
     */
    public ImportedScene withLighting(String comment, Scene lit, Optional<AssetCopy> image, List<String> furtherNotes) {
        List<String> newComments = new ArrayList<>(comments);
        newComments.remove(ADDED_LIGHT_COMMENT);
        if (subject.hasLights()) {
            newComments.add(comment);
        }
        Map<String, Integer> newNotes = new HashMap<>(notes);
        newNotes.remove(ADDED_LIGHT);
        newNotes.remove(ADDED_CAMERA);
        furtherNotes.forEach(note -> newNotes.put(note, 1));
        boolean keepsCamera = lit.camera().equals(unscaledScene.camera());
        Set<String> unused = references(unscaledScene);
        unused.removeAll(references(lit));
        Path folder = ParentFolder.of(sceneFile);
        List<AssetCopy> usedCopies = Stream.concat(image.stream(), copies.stream()
                .filter(copy -> !unused.contains(FileNaming.nameIn(folder, copy.target())))).toList();
        // A new light may have the name of one of the file's that moved.
        Optional<Shot> others = shot().map(s -> s.withTracks(s.tracks().stream()
                .filter(track -> !isLighting(track.target()) && (keepsCamera || !(track.target() instanceof SceneElement.OfCamera)))
                .toList()));
        return new ImportedScene(lit, others.map(s -> validTracks(s, lit)), Set.of(), Set.of(), Optional.empty(), List.copyOf(newComments),
                sceneFile,
                usedCopies, Map.copyOf(newNotes),
                subject, closingComments);
    }

    private static boolean isLighting(SceneElement<?> target) {
        return target instanceof SceneElement.OfLight || target instanceof SceneElement.OfLightGroup;
    }

    /**
     * Returns this scene with names of its files that leave the user's files next to it as they are: {@link FileNaming}.
     *
     * @param renamed receives each name that another file has, and the new name
     * @throws IOException if a file that cannot have another name would replace one, or one cannot be read
     */
    public ImportedScene keepingOthers(BiConsumer<String, String> renamed) throws IOException {
        Set<String> references = references(unscaledScene);
        var naming = new FileNaming(sceneFile);
        Path folder = ParentFolder.of(sceneFile);
        for (AssetCopy copy : copies.stream().sorted(Comparator.comparing(AssetCopy::target)).toList()) {
            naming.add(copy, references.contains(FileNaming.nameIn(folder, copy.target())));
        }
        List<String> newComments = Stream.concat(comments.stream(), naming.comments().stream()).toList();
        naming.renamed().forEach(renamed);
        return new ImportedScene(new FileRenaming(naming::newName).applyTo(unscaledScene), unscaledShot, restored, rawGlows, units,
                newComments,
                sceneFile,
                naming.copies(), notes, subject, closingComments);
    }

    /** Returns the names of the files that a scene references. */
    private static Set<String> references(Scene scene) {
        Set<String> references = new HashSet<>();
        new FileRenaming(name -> {
            references.add(name);
            return name;
        }).applyTo(scene);
        return references;
    }

    /** Returns this scene with further comment lines at the end of its file. */
    public ImportedScene withClosingComments(List<String> further) {
        return new ImportedScene(unscaledScene, unscaledShot, restored, rawGlows, units, comments, sceneFile, copies, notes, subject,
                Stream.concat(closingComments.stream(), further.stream()).toList());
    }

    /** Returns this scene with smooth edges. */
    public ImportedScene withSmoothEdges() {
        PictureSettings picture = unscaledScene.picture();
        return picture.sampling().isSupersampled() ? this : withPicture(picture.withSampling(SMOOTH));
    }

    /**
     * Returns this scene with another exposure of its view; unchanged for 0 stops.
     *
     * @param stops exposure of its view
     */
    public ImportedScene withExposure(double stops) {
        PictureSettings picture = unscaledScene.picture();
        return stops == 0 ? this : withPicture(picture.withView(picture.view().withExposure(stops)));
    }

    /** Returns a shot without the tracks that a scene cannot have. */
    static Shot validTracks(Shot shot, Scene scene) {
        return shot.withTracks(shot.tracks().stream().filter(track -> {
            try {
                track.check(scene);
                return true;
            } catch (RefusalException e) {
                return false;
            }
        }).toList());
    }

    /** Returns whether the scene has indirect light. */
    public boolean hasIndirect() {
        return unscaledScene.picture().indirect().isPresent();
    }

    /** Returns the scene as the {@code .jen} file contains it. */
    public Scene scene() {
        return units.isEmpty() ? unscaledScene : unscaledScene.withLights(unscaledScene.lights().stream()
                .map(light -> restored.contains(light.name()) ? light
                        : light.withIntensity(light.intensity() * units.get().intensityOfOneUnit(light.type())))
                .toList()).withMaterials(unscaledScene.materials().stream()
                        .map(m -> rawGlows.contains(m.name()) ? m.withGlow(m.glow().times(units.get().brightnessOfOneUnit())) : m)
                        .toList());
    }

    /** Returns the animation as the {@code .jen} file contains it; empty for none. */
    public Optional<Shot> shot() {
        return units.isEmpty() ? unscaledShot : unscaledShot.map(s -> s.withTracks(s.tracks().stream().map(this::scaled).toList()));
    }

    /** Returns the keys of an intensity in the units of the scene; those of other attributes as they are. */
    private Track scaled(Track track) {
        boolean isRaw = track.target() instanceof SceneElement.OfLight && !restored.contains(track.target().name())
                && track.attribute().equals(LightAttribute.INTENSITY.name());
        Optional<Light> light = isRaw ? unscaledScene.light(track.target().name()) : Optional.empty();
        if (units.isEmpty() || light.isEmpty()) {
            return track;
        }
        double factor = units.get().intensityOfOneUnit(light.get().type());
        return new Track(track.target(), track.attribute(), track.keys().stream()
                .map(key -> key.value() instanceof KeyframeValue.Numbers(List<Double> numbers)
                        ? new Keyframe(key.frame(), new KeyframeValue.Numbers(numbers.stream().map(v -> v * factor).toList()),
                                key.interpolation())
                        : key)
                .toList());
    }

    /** Returns the text of the {@code .jen} file. */
    public String text() {
        return text(UnaryOperator.identity());
    }

    private String text(UnaryOperator<Scene> change) {
        var header = new StringBuilder(FORMAT_LINE);
        comments.forEach(line -> header.append("# ").append(line).append('\n'));
        units.ifPresent(chosenUnits -> header.append(chosenUnits.comment()).append('\n'));
        Scene written = change.apply(scene());
        String blocks = shot().map(s -> JenWriter.write(written, s)).orElseGet(() -> JenWriter.write(written));
        var footer = new StringBuilder(closingComments.isEmpty() ? "" : "\n");
        closingComments.forEach(line -> footer.append("# ").append(line).append('\n'));
        return header + blocks.substring(FORMAT_LINE.length()) + footer;
    }

    /**
     * Copies the assets, then writes the scene. Replaces no different existing file except the scene itself.
     *
     * @throws IOException if a different file exists or writing fails
     * @throws JenException if the scene could not be read back: an unsupported image format, or a limit exceeded
     */
    public void write() throws IOException, JenException {
        requireNoDifferentFiles();
        writeReplacing();
    }

    /**
     * Copies the assets, then writes the scene. Replaces different existing files, except those that another asset is copied from. At
     * each moment, and after a failure, the scene file is readable and shows the old scene or the new one ({@link SceneReplacement}).
     *
     * @throws IOException if such a file exists or writing fails
     * @throws JenException as {@link #write}
     */
    public void writeReplacing() throws IOException, JenException {
        writeReplacing(SceneReplacement.Observer.NONE);
    }

    void writeReplacing(SceneReplacement.Observer observer) throws IOException, JenException {
        requireNoReplacedSource();
        if (hasAllFiles()) {
            JenReader.read(text(), sceneFile.toString(), ParentFolder.of(sceneFile)).requireAllFiles();
            AtomicFile.of(sceneFile).write(text().getBytes(StandardCharsets.UTF_8));
            StagingFolder.removeStale(sceneFile);
        } else {
            new SceneReplacement(sceneFile, copies, observer).run(this::text);
        }
    }

    /**
     * Copies the assets, and returns what the scene file would contain without writing it. Meshes are not decoded again.
     *
     * @param reader reader of the scene file's folder; keeps decoded files from one import to the next
     * @throws IOException if a different file exists or writing fails
     * @throws JenException as {@link #write}
     */
    public JenDocument document(CachingJenReader reader) throws IOException, JenException {
        requireNoDifferentFiles();
        writeCopies();
        return reader.read(text(), sceneFile.toString(), unscaledScene.stage()).requireAllFiles();
    }

    /** Returns the imported file, the files that it references and those that the scene references. */
    public InputFiles inputs(Path file) {
        Set<Path> files = new HashSet<>(Set.of(file));
        copies.forEach(copy -> {
            files.add(copy.target());
            Optional.ofNullable(copy.source()).ifPresent(files::add);
        });
        return new InputFiles(files);
    }

    /** Returns existing files of other content in the place of assets, in the order of their names. */
    public List<Path> differentFiles() throws IOException {
        List<Path> different = new ArrayList<>();
        for (AssetCopy copy : copies) {
            if (copy.isDifferent()) {
                different.add(copy.target());
            }
        }
        return different.stream().sorted().toList();
    }

    private void requireNoDifferentFiles() throws IOException {
        List<Path> different = differentFiles();
        if (!different.isEmpty()) {
            throw new IOException(Quote.path(different.getFirst()) + ": already exists with other content; import into another folder");
        }
    }

    private void requireNoReplacedSource() throws IOException {
        for (AssetCopy copy : copies) {
            if (copy.isDifferent() && isSource(copy.target())) {
                throw new IOException(Quote.path(copy.target()) + ": is a file of the imported scene; import into another folder");
            }
        }
    }

    private boolean hasAllFiles() throws IOException {
        for (AssetCopy copy : copies) {
            if (!copy.isWritten()) {
                return false;
            }
        }
        return true;
    }

    private void writeCopies() throws IOException {
        for (AssetCopy copy : copies) {
            if (!copy.isWritten()) {
                copy.write();
            }
        }
    }

    private boolean isSource(Path target) throws IOException {
        for (AssetCopy copy : copies) {
            if (copy.source() != null && Files.isSameFile(copy.source(), target)) {
                return true;
            }
        }
        return false;
    }
}
