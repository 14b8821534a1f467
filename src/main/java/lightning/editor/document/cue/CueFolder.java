package lightning.editor.document.cue;

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
import lightning.base.file.OrdinaryFile;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.format.picture.PictureFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Stage;

/**
 * The cues of a scene: the folder {@code NAME.cues} beside {@code NAME.jen}, with two files for each, its lights as blocks of a scene file and
 * its picture as PNG. All methods read or write files, and belong on no window's thread.
 */
public final class CueFolder {
    /** More than these are not listed. */
    public static final int MOST = 200;
    /** Characters of a name. */
    private static final int LONGEST = 60;
    /** Those that some system takes for more than a part of a name. */
    private static final String UNFIT = "/\\:*?\"<>|";
    private static final String LIGHTS = ".jen";
    private static final String PICTURE = ".png";

    private final Path scene;
    private final Path folder;

    /** @param scene the scene's file */
    public CueFolder(Path scene) {
        this.scene = scene.toAbsolutePath();
        String name = scene.getFileName().toString();
        String stem = name.endsWith(LIGHTS) ? name.substring(0, name.length() - LIGHTS.length()) : name;
        folder = this.scene.resolveSibling(stem + ".cues");
    }

    /** Where the cues are, or would be. */
    public Path path() {
        return folder;
    }

    /** Why a cue cannot have a name: a clause; empty where it can. */
    public static Optional<String> refusal(String name) {
        if (name.isBlank()) {
            return Optional.of(Texts.of("a cue needs a name"));
        }
        if (name.length() > LONGEST) {
            return Optional.of(Texts.of("the name of a cue may have {0} characters, this has {1}", LONGEST, name.length()));
        }
        Optional<String> unfit = name.chars().filter(c -> UNFIT.indexOf(c) >= 0 || Character.isISOControl(c)).boxed().findFirst()
                .map(c -> Texts.of("the name of a cue is that of a file, which cannot have {0}", Quote.of(Character.toString(c))));
        return unfit.or(() -> name.startsWith(".") || name.endsWith(".") || !name.equals(name.strip())
                ? Optional.of(Texts.of("the name of a cue begins and ends with neither a space nor a full stop, {0} does", Quote.of(name)))
                : Optional.empty());
    }

    /**
     * All cues by name, each with its lights and its picture or why there is none.
     *
     * @param stage the scene's
     * @throws IOException if the folder cannot be read, or leads out of the scene's
     */
    public List<Cue> list(Stage stage) throws IOException {
        if (!Files.exists(folder)) {
            return List.of();
        }
        check(folder);
        List<Path> files;
        try (Stream<Path> all = Files.list(folder)) {
            files = all.filter(f -> f.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(LIGHTS)
                    && !f.getFileName().toString().startsWith(".")).sorted().limit(MOST).toList();
        }
        List<Cue> cues = new ArrayList<>();
        for (Path file : files) {
            cues.add(cue(file, stage));
        }
        return cues;
    }

    private Cue cue(Path file, Stage stage) {
        String title = file.getFileName().toString();
        String name = title.substring(0, title.length() - LIGHTS.length());
        Optional<Lighting> lighting = Optional.empty();
        String problem = "";
        try {
            check(file);
            lighting = Optional.of(Lighting.read(file, scene.getParent(), stage));
        } catch (IOException e) {
            problem = e.getMessage() == null ? Texts.of("{0} cannot be read", Quote.path(file)) : e.getMessage();
        }
        return new Cue(name, file, lighting, problem, picture(file(name, PICTURE)));
    }

    private Optional<Film> picture(Path file) {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            check(file);
            OrdinaryFile.check(file, "a PNG picture");
            return Optional.of(PictureFile.read(file));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** No link leads out of the scene's folder. */
    private void check(Path file) throws IOException {
        if (!file.toRealPath().startsWith(scene.getParent().toRealPath())) {
            throw new IOException(Texts.of("{0}: leads out of the scene's folder", Quote.path(file)));
        }
    }

    private Path file(String name, String ending) {
        return folder.resolve(name + ending);
    }

    /**
     * Keeps a cue, in place of one of that name.
     *
     * @param film what is seen, by {@code view}
     * @throws IOException if it cannot be written; the old one is then unchanged, or has a new picture
     */
    public void keep(String name, Lighting lighting, Film film, ViewTransform view) throws IOException {
        Optional<String> refusal = refusal(name);
        if (refusal.isPresent()) {
            throw new IOException(refusal.get());
        }
        if (!Files.exists(folder)) {
            Files.createDirectory(folder);
        }
        check(folder);
        PictureFile.write(file(name, PICTURE), film, view);
        lighting.write(file(name, LIGHTS));
    }

    /** Whether there is one of that name. */
    public boolean has(String name) {
        return Files.exists(file(name, LIGHTS));
    }

    /**
     * Gives a cue another name.
     *
     * @throws IOException if there is one of that name, or it cannot be moved
     */
    public void rename(String from, String to) throws IOException {
        Optional<String> refusal = refusal(to);
        if (refusal.isPresent()) {
            throw new IOException(refusal.get());
        }
        check(folder);
        for (String ending : List.of(LIGHTS, PICTURE)) {
            if (Files.exists(file(to, ending))) {
                throw new FileAlreadyExistsException(file(to, ending).toString(), null, Texts.of("is there already"));
            }
        }
        if (Files.exists(file(from, PICTURE))) {
            Files.move(file(from, PICTURE), file(to, PICTURE));
        }
        Files.move(file(from, LIGHTS), file(to, LIGHTS));
    }

    /** Takes a cue away: its files get the ending {@code .gone}, from which {@link #bringBack} brings them back. */
    public void remove(String name) throws IOException {
        check(folder);
        for (String ending : List.of(LIGHTS, PICTURE)) {
            if (Files.exists(file(name, ending))) {
                Files.move(file(name, ending), file(name, ending + ".gone"), StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }

    /**
     * Brings back a cue that was removed.
     *
     * @throws IOException if there is one of that name again, or nothing to bring back
     */
    public void bringBack(String name) throws IOException {
        check(folder);
        if (has(name)) {
            throw new FileAlreadyExistsException(file(name, LIGHTS).toString(), null, Texts.of("is there already"));
        }
        for (String ending : List.of(PICTURE, LIGHTS)) {
            if (Files.exists(file(name, ending + ".gone"))) {
                Files.move(file(name, ending + ".gone"), file(name, ending), StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }
}
