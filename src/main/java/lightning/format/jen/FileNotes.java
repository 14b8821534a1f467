package lightning.format.jen;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Images, profiles and meshes of a scene file that are left out or reduced. */
final class FileNotes {
    private final ProblemList list;
    private final boolean refuses;
    private final Set<LeftOutFile> leftOut = new HashSet<>();

    private FileNotes(ProblemList list, boolean refuses) {
        this.list = list;
        this.refuses = refuses;
    }

    /** Creates notes of a scene that is shown without these files. */
    static FileNotes create() {
        return new FileNotes(new ProblemList(), false);
    }

    /** Returns notes that are problems: a scene without these files is refused. */
    static FileNotes asProblems(ProblemList problems) {
        return new FileNotes(problems, true);
    }

    /**
     * Adds a file that cannot be used.
     *
     * @param offset position of its name, in characters
     * @param reason clause about the block and the file
     */
    void leaveOut(int offset, LeftOutFile file, String reason) {
        leftOut.add(file);
        list.add(offset, refuses ? reason : reason + "; left out");
    }

    /** Adds a file that is used with fewer pixels. */
    void reduce(int offset, String reason) {
        list.add(offset, reason);
    }

    /** Returns the notes in file order. */
    List<Problem> toProblems(SourceText source) {
        return list.toProblems(source);
    }

    Set<LeftOutFile> leftOut() {
        return Set.copyOf(leftOut);
    }
}
