package lightning;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.cli.ResidentRun;
import lightning.editor.window.LightningApp;
import lightning.format.assimp.AssimpConverter;
import lightning.format.assimp.AssimpProcess;
import lightning.format.jen.JenFile;

/** Starts the program. */
public final class Main {
    /** Seconds that Ctrl-C waits for a command to clean up its output files. */
    private static final int CANCEL_TIMEOUT_SECONDS = 5;
    private static final int BAD_INPUT = 2;
    /** System property that asks for the tour if no window can be opened. */
    private static final String TOUR_PROPERTY = "lightning.tour";

    private Main() {}

    /**
     * Opens the editor if there are no arguments or one file that it can open, with or without the word {@code edit}; otherwise runs the
     * named command. Exits with its code. If no window can be opened, says which commands need none.
     */
    public static void main(String[] args) {
        if (args.length > 0 && args[0].equals(AssimpConverter.COMMAND)) {
            // The library may crash while it is unloaded.
            Runtime.getRuntime().halt(convertModel(args));
        }
        if (!opensEditor(args)) {
            runCommand(args);
        }
        List<String> file = fileArguments(args);
        Optional<String> reason = LightningApp.open(file);
        if (reason.isEmpty()) {
            System.exit(0);
        }
        if (Boolean.getBoolean(TOUR_PROPERTY) && file.stream().allMatch(Main::isScene)) {
            System.err.println("lightning: " + reason.get() + "; running 'lightning tour' instead.");
            runCommand(Stream.concat(Stream.of("tour"), file.stream()).toArray(String[]::new));
        }
        System.err.println(withoutWindow(reason.get(), file));
        System.exit(BAD_INPUT);
    }

    /** Runs the command of the process that converts other programs' files; returns its exit code. */
    private static int convertModel(String... args) {
        try {
            AssimpProcess.convert(Path.of(args[1]), Path.of(args[2]), Long.parseLong(args[3]), Boolean.parseBoolean(args[4]))
                    .forEach(System.out::println);
            System.out.flush();
            return 0;
        } catch (IOException | RuntimeException e) {
            System.err.println(e.getMessage());
            return AssimpProcess.FAILED;
        }
    }

    private static boolean isScene(String name) {
        return name.endsWith(JenFile.EXTENSION);
    }

    /**
     * Returns the message for a machine without a display.
     *
     * @param reason why no window can be opened, a clause
     * @param file   the file to open, or nothing
     */
    static String withoutWindow(String reason, List<String> file) {
        String start = "lightning: " + reason + "\n";
        if (!file.stream().allMatch(Main::isScene)) {
            return start + "'lightning import' converts the file without a window.";
        }
        String name = file.isEmpty() ? "scenes/bird.jen" : file.getFirst();
        return start + String.format(Locale.ROOT, """
                Lightning lights ray-traced scenes, in a window or by commands such as:
                  lightning render %s -o picture.png   render an image
                  lightning tour %s   make every kind of edit, with images and times, for some minutes
                  lightning --help   list all commands""", name, name);
    }

    static boolean opensEditor(String... args) {
        List<String> file = fileArguments(args);
        return file.isEmpty() || file.size() == 1 && LightningApp.canOpen(file.getFirst()) && !file.getFirst().startsWith("-");
    }

    /** Returns the arguments without the word {@code edit}. */
    private static List<String> fileArguments(String... args) {
        return List.of(args).subList(args.length > 0 && args[0].equals("edit") ? 1 : 0, args.length);
    }

    private static void runCommand(String... args) {
        Thread command = Thread.currentThread();
        CountDownLatch finished = new CountDownLatch(1);
        Runtime.getRuntime().addShutdownHook(new Thread(() -> awaitCancellation(command, finished), "lightning-interrupt"));
        int exit = run(args);
        finished.countDown();
        System.exit(exit);
    }

    private static int run(String... args) {
        try {
            return ResidentRun.run(System.out, System.err, args);
        } catch (LinkageError e) {
            // Not even the class that formats errors could be loaded.
            System.err.println("lightning: cannot load a part of the program (" + e.getMessage()
                    + "); if too many files are open, raise the limit, for example with 'ulimit -n 4096', and restart");
            return BAD_INPUT;
        }
    }

    /** Lets an interrupted command remove its temporary file before the process ends. */
    private static void awaitCancellation(Thread command, CountDownLatch finished) {
        if (finished.getCount() == 0) {
            return;
        }
        command.interrupt();
        try {
            finished.await(CANCEL_TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
