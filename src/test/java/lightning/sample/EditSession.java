package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import lightning.format.jen.JenWriter;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** What an artist did: a scene, and edits of it one after the other. */
public final class EditSession {
    private final List<Edit> edits;
    private final List<Scene> scenes = new ArrayList<>();

    private EditSession(List<Edit> edits, Scene first) {
        this.edits = edits;
        scenes.add(first);
        for (Edit edit : edits) {
            scenes.add(edit.applyIfValid(scenes));
        }
    }

    /** Sessions of one to twelve edits; in search of the plainest failure, edits are left out first. */
    public static Arbitrary<EditSession> sessions() {
        return Combinators.combine(EditArbitraries.sequences(), SceneArbitraries.scenes()).as(EditSession::new);
    }

    /** Sessions of one to twelve edits of how strongly lights shine and how they fade. */
    public static Arbitrary<EditSession> scaleSessions() {
        return Combinators.combine(EditArbitraries.scaleSequences(), SceneArbitraries.scenes()).as(EditSession::new);
    }

    /** Sessions of one to ten edits with weights, falloffs and highlights down to what a float can no longer hold. */
    public static Arbitrary<EditSession> extremeSessions() {
        return Combinators.combine(ExtremeArbitraries.edits(), ExtremeArbitraries.scenes()).as(EditSession::new);
    }

    /** The first scene and the scene after each edit. */
    public List<Scene> scenes() {
        return scenes;
    }

    /** The first scene as a file, then the edits. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("\n").append(JenWriter.write(scenes.getFirst())).append('\n');
        edits.forEach(e -> text.append("# ").append(e).append('\n'));
        return text.toString();
    }
}
