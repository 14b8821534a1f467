package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.StreamSupport;
import lightning.format.jen.JenWriter;
import lightning.scene.Scene;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Editing session: a scene and a sequence of edits. */
public final class EditSession {
    private final List<Edit> edits;
    private final List<Scene> scenes;

    private EditSession(List<Edit> edits, Scene first) {
        this.edits = edits;
        List<Scene> edited = new ArrayList<>(List.of(first));
        for (Edit edit : edits) {
            edited.add(edit.applyIfValid(edited));
        }
        scenes = TestBudget.limit(edited);
    }

    /** Returns sessions of one to twelve edits; shrinking removes edits first. */
    public static Arbitrary<EditSession> sessions() {
        return Combinators.combine(EditArbitraries.sequences(), SceneArbitraries.scenes()).as(EditSession::new);
    }

    /** Returns sessions of one to twelve edits of scenes in fog with mirrors and glass. */
    public static Arbitrary<EditSession> fogSessions() {
        return Combinators.combine(EditArbitraries.sequences(), FogArbitraries.scenes()).as(EditSession::new);
    }

    /** Returns sessions of which a small share has indirect light, which takes much more time. */
    public static Arbitrary<EditSession> mixedSessions() {
        return Arbitraries.frequencyOf(Tuple.of(11, sessions()), Tuple.of(1, indirectSessions()));
    }

    /** Returns sessions of one to twelve edits of light intensity and falloff. */
    public static Arbitrary<EditSession> scaleSessions() {
        return Combinators.combine(EditArbitraries.scaleSequences(), SceneArbitraries.scenes()).as(EditSession::new);
    }

    /** Returns sessions of one to eight edits of scenes with indirect light. */
    public static Arbitrary<EditSession> indirectSessions() {
        return Combinators.combine(IndirectArbitraries.edits(), IndirectArbitraries.scenes()).as(EditSession::new);
    }

    /** Returns sessions of one to eight edits of objects in rooms with indirect light. */
    public static Arbitrary<EditSession> indirectObjectSessions() {
        return Combinators.combine(IndirectArbitraries.objectEdits(), IndirectArbitraries.rooms()).as(EditSession::new);
    }

    /** Returns sessions of one to eight edits of environments, lights and objects in rooms, some with indirect light. */
    public static Arbitrary<EditSession> environmentSessions() {
        return Combinators.combine(IndirectArbitraries.environmentEdits(), IndirectArbitraries.roomsWithEnvironment()).as(EditSession::new);
    }

    /** Returns sessions of one to ten edits with weights, falloffs and highlights down to the underflow of a float. */
    public static Arbitrary<EditSession> extremeSessions() {
        return Combinators.combine(ExtremeArbitraries.edits(), ExtremeArbitraries.scenes()).as(EditSession::new);
    }

    /** Returns the first scene and the scene after each edit. */
    public List<Scene> scenes() {
        return scenes;
    }

    /**
     * Returns the indexes of these scenes, for a loop that renders them. It ends early when the {@link TestBudget} of a session is spent, but
     * not before the second scene.
     */
    public Iterable<Integer> steps() {
        return () -> {
            var budget = new TestBudget();
            return IntStream.range(0, scenes.size()).takeWhile(step -> step < 2 || !budget.isSpent()).iterator();
        };
    }

    /** Returns the scenes of {@link #steps}; the last one is not always the last of {@link #scenes}. */
    public Iterable<Scene> timedScenes() {
        return () -> StreamSupport.stream(steps().spliterator(), false).map(scenes::get).iterator();
    }

    /** Returns the first scene as a file, then the edits. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("\n").append(JenWriter.write(scenes.getFirst())).append('\n');
        scenes.getFirst().picture().indirect().ifPresent(indirect -> text.append("# ").append(indirect).append('\n'));
        edits.forEach(e -> text.append("# ").append(e).append('\n'));
        return text.toString();
    }
}
