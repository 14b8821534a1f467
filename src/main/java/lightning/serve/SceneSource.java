package lightning.serve;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import lightning.base.file.ParentFolder;
import lightning.base.file.ShippedFile;
import lightning.base.work.Progress;
import lightning.document.OpenDocument;
import lightning.format.exchange.ImportLighting;
import lightning.format.exchange.ImportOptions;
import lightning.format.exchange.IndirectChoice;
import lightning.format.exchange.SceneImporter;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.CachingJenReader;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import lightning.format.mesh.MeshException;
import org.jspecify.annotations.Nullable;

/** Reads the scene of an {@code open} or {@code replace} request: a scene file, a text, or another program's file. */
final class SceneSource {
    private static final List<String> IMPORT_FIELDS =
            List.of("output", "indirect", "light_units", "lighting", "subdivision", "variant", "camera", "frame");

    /** Reader of the last import's folder, with the files that it decoded; null before. */
    private @Nullable CachingJenReader importReader;
    private List<String> notes = List.of();

    /** Returns what the last scene's import left out or approximated. */
    List<String> notes() {
        return notes;
    }

    /** Opens a file or a text. */
    OpenDocument open(Fields fields, Progress progress) throws IOException, JenException {
        Optional<String> file = fields.optionalString("file");
        Optional<String> text = fields.optionalString("text");
        Optional<String> folder = fields.optionalString("folder");
        if (file.isPresent() == text.isPresent()) {
            throw Fields.bad("file", "expected either a file or a text");
        }
        if (file.isPresent() && folder.isPresent()) {
            throw Fields.bad("folder", "only a text has a folder; a file's own folder counts");
        }
        if (file.isPresent() && SceneImporter.isImportName(file.get())) {
            return read(Path.of(file.get()), output(fields), fields, progress);
        }
        for (String field : IMPORT_FIELDS) {
            if (fields.has(field)) {
                throw Fields.bad(field, "only files that are imported have this field");
            }
        }
        notes = List.of();
        return file.isPresent() ? OpenDocument.open(ShippedFile.resolve(Path.of(file.get())))
                : OpenDocument.openText(text.orElseThrow(), Path.of(folder.orElse("")).toAbsolutePath());
    }

    private static Path output(Fields fields) {
        String name = fields.optionalString("output")
                .orElseThrow(() -> Fields.bad("output", "missing; expected the .jen file that the import would write"));
        if (!JenFile.isJenFileName(name.toLowerCase(Locale.ROOT))) {
            throw Fields.bad("output", "a scene's file name must end in " + JenFile.EXTENSION);
        }
        return Path.of(name).toAbsolutePath();
    }

    /** Imports a file as {@code lightning import} does, without writing the scene file. */
    private OpenDocument read(Path file, Path output, Fields fields, Progress progress) throws IOException, JenException {
        IndirectChoice indirect = fields.choice("indirect", IndirectChoice.AUTO);
        ImportLighting lighting = fields.choice("lighting", ImportLighting.FILE);
        var options = new ImportOptions(
                fields.has("light_units") ? Optional.of(fields.choice("light_units", LightUnits.CANDELA)) : Optional.empty(),
                fields.integer("subdivision", 0, SceneImporter.MAX_LEVELS, SceneImporter.DEFAULT_LEVELS),
                fields.has("variant") ? fields.strings("variant") : List.of(), fields.optionalString("camera").orElse(""),
                fields.number("frame", -ImportOptions.MAX_FRAME, ImportOptions.MAX_FRAME));
        try {
            ImportedScene imported = lighting.apply(indirect.apply(SceneImporter.read(file, output, options, progress)));
            if (importReader == null || !importReader.folder().equals(ParentFolder.of(output))) {
                importReader = new CachingJenReader(ParentFolder.of(output));
            }
            progress.checkCanceled("canceled after the import");
            OpenDocument document = OpenDocument.openContent(output, imported.document(importReader));
            notes = imported.notes().keySet().stream().sorted().toList();
            return document;
        } catch (MeshException e) {
            throw new RequestException(ErrorCode.BAD_SCENE, "", e.getMessage());
        }
    }
}
