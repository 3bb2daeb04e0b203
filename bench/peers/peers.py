"""peers.py PACKAGE: solves quadratic programmes from the standard input with a Python package.

Reads n, m, calls (64-bit integers) and K, p, A, g (doubles, column by column); minimises
1/2 x'Kx - p'x with Ax <= g `calls` times in a row; writes as doubles the mean processor seconds of one
call, its iterations, the length of a message, then x, the multipliers, and the message, which is empty
if the package says that it has solved the problem. Ends with the input. Only the package's own work is
timed: matrices are in its own form before the clock starts.
"""

import array
import math
import os
import sys
import time


def prepare_cvxopt(n, m, K, p, A, g):
    from cvxopt import matrix, solvers

    solvers.options["show_progress"] = False
    data = [matrix(K, (n, n)), -matrix(p), matrix(A, (m, n)), matrix(g)]

    def solve():
        return solvers.qp(*data)

    def read(result):
        wrong = "" if result["status"] == "optimal" else result["status"]
        return result["iterations"], list(result["x"]), list(result["z"]), wrong

    return solve, read


def prepare_highspy(n, m, K, p, A, g):
    import highspy
    import numpy

    model = highspy.HighsModel()
    model.lp_.num_col_, model.lp_.num_row_ = n, m
    model.lp_.col_cost_ = -numpy.array(p)
    model.lp_.col_lower_ = numpy.full(n, -highspy.kHighsInf)
    model.lp_.col_upper_ = numpy.full(n, highspy.kHighsInf)
    model.lp_.row_lower_ = numpy.full(m, -highspy.kHighsInf)
    model.lp_.row_upper_ = numpy.array(g)
    model.lp_.a_matrix_.format_ = highspy.MatrixFormat.kColwise
    model.lp_.a_matrix_.start_ = numpy.arange(0, n * m + 1, m)
    model.lp_.a_matrix_.index_ = numpy.tile(numpy.arange(m), n)
    model.lp_.a_matrix_.value_ = numpy.array(A)
    lower = numpy.concatenate([numpy.arange(j, n) for j in range(n)])
    model.hessian_.dim_ = n
    model.hessian_.format_ = highspy.HessianFormat.kTriangular
    model.hessian_.start_ = numpy.concatenate([[0], numpy.cumsum(numpy.arange(n, 0, -1))])
    model.hessian_.index_ = lower
    model.hessian_.value_ = numpy.concatenate([K[j * n + j:(j + 1) * n] for j in range(n)])

    def solve():
        solver = highspy.Highs()
        solver.setOptionValue("output_flag", False)
        solver.passModel(model)
        solver.run()
        return solver

    def read(solver):
        status = solver.getModelStatus()
        wrong = "" if status == highspy.HighsModelStatus.kOptimal else str(status)
        solution = solver.getSolution()
        iterations = solver.getInfo().qp_iteration_count
        return iterations, list(solution.col_value), [-z for z in solution.row_dual], wrong

    return solve, read


def prepare_osqp(n, m, K, p, A, g):
    import numpy
    import osqp
    from scipy import sparse

    stiffness = sparse.triu(numpy.array(K).reshape(n, n), format="csc")
    rows = sparse.csc_matrix(numpy.array(A).reshape(n, m).T)
    load, gap = -numpy.array(p), numpy.array(g)
    below = numpy.full(m, -numpy.inf)

    def solve():
        solver = osqp.OSQP()
        solver.setup(P=stiffness, q=load, A=rows, l=below, u=gap, verbose=False, eps_abs=1e-9,
                     eps_rel=1e-9, max_iter=100000)
        return solver.solve()

    def read(result):
        wrong = "" if result.info.status == "solved" else result.info.status
        return result.info.iter, list(result.x), list(result.y), wrong

    return solve, read


def doubles(stream, count):
    data = array.array("d")
    data.frombytes(stream.read(8 * count))
    return data


def main(package):
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what packages print is no answer
    prepare = {"cvxopt": prepare_cvxopt, "highspy": prepare_highspy, "osqp": prepare_osqp}[package]
    while True:
        sizes = array.array("q")
        sizes.frombytes(sys.stdin.buffer.read(24))
        if len(sizes) < 3:
            return
        n, m, calls = sizes
        K, p, A, g = [doubles(sys.stdin.buffer, count) for count in (n * n, n, m * n, m)]
        seconds, iterations, x, z = 0.0, 0, [math.nan] * n, [math.nan] * m
        try:
            solve, read = prepare(n, m, K, p, A, g)
            begin = time.process_time()
            for _ in range(calls):
                result = solve()
            seconds = (time.process_time() - begin) / calls
            iterations, x, z, wrong = read(result)
        except Exception as error:  # whatever it is, the table must say it
            wrong = f"{type(error).__name__}: {error}"
        message = wrong.encode()
        array.array("d", [seconds, iterations, len(message), *x, *z]).tofile(answers)
        answers.write(message)
        answers.flush()


main(sys.argv[1])
