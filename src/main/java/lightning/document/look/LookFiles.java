package lightning.document.look;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.file.ParentFolder;
import lightning.base.file.RegularFile;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.LooksFolder;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Stage;

/**
 * Folder {@code NAME.cues} next to {@code NAME.jen} with the saved looks of a scene. Each has two files: its lights as blocks of a scene
 * file, and its image as PNG. All methods access files; do not call them on a window's thread.
 */
public final class LookFiles {
    /** Maximum number of listed looks. */
    public static final int MAX_CUES = 200;
    /** Maximum length of a name, in characters. */
    private static final int MAX_NAME_LENGTH = 60;
    /** Characters with a special meaning in file names on some system. */
    private static final String FORBIDDEN_CHARACTERS = "/\\:*?\"<>|";
    private static final String LIGHTS_EXTENSION = LooksFolder.LIGHTS_EXTENSION;
    private static final String PICTURE_EXTENSION = LooksFolder.PICTURE_EXTENSION;

    /** Folder of the scene, in which files of lights are searched. */
    private final Path sceneFolder;
    private final Path folder;

    private LookFiles(Path sceneFolder, Path folder) {
        this.sceneFolder = sceneFolder;
        this.folder = folder;
    }

    /** @param scene scene file */
    public LookFiles(Path scene) {
        this(ParentFolder.of(scene), LooksFolder.of(scene));
    }

    /**
     * Creates the folder of a scene that has no file of its own.
     *
     * @param scene file that the scene is a copy of, or its proposed file
     * @param folder private folder, which may not exist
     */
    public static LookFiles ofUntitled(Path scene, Path folder) {
        return new LookFiles(ParentFolder.of(scene), folder.toAbsolutePath());
    }

    /** Returns the folder, which may not exist. */
    public Path path() {
        return folder;
    }

    /** Returns the reason why a name is invalid, a clause; empty if it is valid. */
    public static Optional<String> nameProblem(String name) {
        if (name.isBlank()) {
            return Optional.of(Messages.tr("enter a look name"));
        }
        if (name.length() > MAX_NAME_LENGTH) {
            return Optional.of(Messages.tr("a look name can have at most {0} characters, found {1}", MAX_NAME_LENGTH, name.length()));
        }
        Optional<String> forbidden = name.chars().filter(c -> FORBIDDEN_CHARACTERS.indexOf(c) >= 0 || Character.isISOControl(c)).boxed()
                .findFirst()
                .map(c -> Messages.tr("a look name is a file name and cannot contain {0}", Quote.of(Character.toString(c))));
        return forbidden.or(() -> name.startsWith(".") || name.endsWith(".") || !name.equals(name.strip())
                ? Optional
                        .of(Messages.tr("a look name cannot start or end with a space or period, found {0}", Quote.of(name)))
                : Optional.empty());
    }

    /**
     * Returns all looks by name, each with its lights and image, or the reason why they cannot be read.
     *
     * @param stage stage of the scene
     * @throws IOException if the folder cannot be read, or is outside the scene's folder
     */
    public List<Look> list(Stage stage) throws IOException {
        if (!Files.exists(folder)) {
            return List.of();
        }
        checkInsideSceneFolder(folder);
        List<Path> files;
        try (Stream<Path> all = Files.list(folder)) {
            files = all.filter(f -> f.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(LIGHTS_EXTENSION)
                    && !f.getFileName().toString().startsWith(".")).sorted().limit(MAX_CUES).toList();
        }
        List<Look> looks = new ArrayList<>();
        for (Path file : files) {
            looks.add(readLook(file, stage));
        }
        return looks;
    }

    private Look readLook(Path file, Stage stage) {
        String title = file.getFileName().toString();
        String name = title.substring(0, title.length() - LIGHTS_EXTENSION.length());
        Optional<Lighting> lighting = Optional.empty();
        String problem = "";
        try {
            checkInsideSceneFolder(file);
            lighting = Optional.of(Lighting.read(file, sceneFolder, stage));
        } catch (IOException e) {
            problem = e.getMessage() == null ? Messages.tr("{0} cannot be read", Quote.path(file)) : e.getMessage();
        }
        return new Look(name, file, lighting, problem, readPicture(file(name, PICTURE_EXTENSION)));
    }

    private Optional<Film> readPicture(Path file) {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            checkInsideSceneFolder(file);
            RegularFile.check(file, "a PNG image");
            return Optional.of(ImageFile.read(file));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** Checks that no link leads out of the scene's folder. */
    private void checkInsideSceneFolder(Path file) throws IOException {
        if (!file.toRealPath().startsWith(ParentFolder.of(folder).toRealPath())) {
            throw new IOException(Messages.tr("{0}: expected a file in the scene's folder", Quote.path(file)));
        }
    }

    private Path file(String name, String extension) {
        return folder.resolve(name + extension);
    }

    /**
     * Saves a look, replacing one with the same name.
     *
     * @param film image, displayed with {@code view}
     * @throws IOException if it cannot be written; the old one is then unchanged, or has the new image
     */
    public void save(String name, Lighting lighting, Film film, ViewTransform view) throws IOException {
        Optional<String> problem = nameProblem(name);
        if (problem.isPresent()) {
            throw new IOException(problem.get());
        }
        Files.createDirectories(folder);
        checkInsideSceneFolder(folder);
        ImageFile.write(file(name, PICTURE_EXTENSION), film, view);
        lighting.write(file(name, LIGHTS_EXTENSION));
    }

    /** Returns whether a look with that name exists. */
    public boolean has(String name) {
        return Files.exists(file(name, LIGHTS_EXTENSION));
    }

    /**
     * Renames a look.
     *
     * @throws IOException if the new name is taken, or the files cannot be moved
     */
    public void rename(String from, String to) throws IOException {
        Optional<String> problem = nameProblem(to);
        if (problem.isPresent()) {
            throw new IOException(problem.get());
        }
        checkInsideSceneFolder(folder);
        for (String extension : List.of(LIGHTS_EXTENSION, PICTURE_EXTENSION)) {
            if (Files.exists(file(to, extension))) {
                throw new FileAlreadyExistsException(file(to, extension).toString(), null, Messages.tr("name already in use"));
            }
        }
        if (Files.exists(file(from, PICTURE_EXTENSION))) {
            Files.move(file(from, PICTURE_EXTENSION), file(to, PICTURE_EXTENSION));
        }
        Files.move(file(from, LIGHTS_EXTENSION), file(to, LIGHTS_EXTENSION));
    }

    /** Removes a look: renames its files to {@code .gone}, from which {@link #restore} recovers them. */
    public void remove(String name) throws IOException {
        checkInsideSceneFolder(folder);
        for (String extension : List.of(LIGHTS_EXTENSION, PICTURE_EXTENSION)) {
            if (Files.exists(file(name, extension))) {
                Files.move(file(name, extension), file(name, extension + ".gone"), StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }

    /**
     * Restores a removed look.
     *
     * @throws IOException if the name is taken, or nothing can be restored
     */
    public void restore(String name) throws IOException {
        checkInsideSceneFolder(folder);
        if (has(name)) {
            throw new FileAlreadyExistsException(file(name, LIGHTS_EXTENSION).toString(), null, Messages.tr("name already in use"));
        }
        for (String extension : List.of(PICTURE_EXTENSION, LIGHTS_EXTENSION)) {
            if (Files.exists(file(name, extension + ".gone"))) {
                Files.move(file(name, extension + ".gone"), file(name, extension), StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }
}
