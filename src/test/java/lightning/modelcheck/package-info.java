/** Threads under a model checker: a story told in many schedules, each of which must keep the laws. */
package lightning.modelcheck;
